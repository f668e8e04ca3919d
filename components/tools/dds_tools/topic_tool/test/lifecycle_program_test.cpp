// SPDX-License-Identifier: Apache-2.0
// `tocsin lifecycle` where its page does not play it (test/system), and its texts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command_line/run_to_end.hpp"
#include "lifecycle_text.hpp"

namespace tocsin::topic_tool {
namespace {

Transitions transitions() {
  Transitions all(2);
  all[0].transition().id(4);
  all[0].transition().label("deactivate");
  all[0].start_state().label("active");
  all[0].goal_state().label("deactivating");
  all[1].transition().id(7);
  all[1].transition().label("active_shutdown\x1b");
  return all;
}

TEST(LifecycleText, ATransitionIsMeantByItsNameOrItsNumber) {
  EXPECT_EQ(chosen(transitions(), "deactivate")->id(), 4);
  EXPECT_EQ(chosen(transitions(), "7")->id(), 7);
  EXPECT_FALSE(chosen(transitions(), "activate"));
  EXPECT_EQ(unknown_text(transitions()),
            "Unknown transition requested, available ones are:\n- deactivate [4]\n"
            "- active_shutdown\\x1b [7]\n");
  EXPECT_EQ(transitions_text({transitions()[0]}),
            "- deactivate [4]\n\tStart: active\n\tGoal: deactivating\n");
}

TEST(LifecycleProgram, SaysInOneLineThatANodeHasNone) {
  const Ended sut =
      run_to_end({LIFECYCLE_PROGRAM, "get", "/nobody", "--timeout", "0.3", "--domain", "93"});
  EXPECT_EQ(sut.code, 1);
  EXPECT_THAT(sut.output, ::testing::HasSubstr("service /nobody/get_state: nobody serves it\n"));
}

}  // namespace
}  // namespace tocsin::topic_tool
