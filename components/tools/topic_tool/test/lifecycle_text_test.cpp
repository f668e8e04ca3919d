// SPDX-License-Identifier: Apache-2.0
#include "lifecycle_text.hpp"

#include <gtest/gtest.h>

namespace tocsin::topic_tool {
namespace {

lifecycle_msgs::msg::TransitionDescription way(std::uint8_t id, const char* label, const char* from,
                                               const char* to) {
  lifecycle_msgs::msg::TransitionDescription made;
  made.transition().id(id);
  made.transition().label(label);
  made.start_state().label(from);
  made.goal_state().label(to);
  return made;
}

const Transitions ways{way(4, "deactivate", "active", "deactivating"),
                       way(7, "shutdown", "active", "shuttingdown")};

TEST(LifecycleText, AStateHasItsNumberBehindIt) {
  lifecycle_msgs::msg::State state;
  state.id(3);
  state.label("active");
  EXPECT_EQ(state_text(state), "active [3]");
  state.label("a\x1b");
  EXPECT_EQ(state_text(state), "a\\x1b [3]");
}

TEST(LifecycleText, TransitionsStandAsRos2PrintsThem) {
  EXPECT_EQ(transitions_text(ways),
            "- deactivate [4]\n\tStart: active\n\tGoal: deactivating\n"
            "- shutdown [7]\n\tStart: active\n\tGoal: shuttingdown\n");
  EXPECT_EQ(transitions_text({}), "");
}

TEST(LifecycleText, ATransitionIsMeantByItsLabelOrItsNumber) {
  ASSERT_TRUE(chosen(ways, "shutdown"));
  EXPECT_EQ(chosen(ways, "shutdown")->id(), 7);
  ASSERT_TRUE(chosen(ways, "4"));
  EXPECT_EQ(chosen(ways, "4")->label(), "deactivate");
  EXPECT_FALSE(chosen(ways, "activate"));
  EXPECT_FALSE(chosen(ways, ""));
}

TEST(LifecycleText, AnUnknownOneIsAnsweredWithThoseThatThereAre) {
  EXPECT_EQ(unknown_text(ways),
            "Unknown transition requested, available ones are:\n"
            "- deactivate [4]\n- shutdown [7]\n");
}

}  // namespace
}  // namespace tocsin::topic_tool
