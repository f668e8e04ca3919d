// SPDX-License-Identifier: Apache-2.0
// `tocsin node` where its page does not play it (test/system).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command_line/run_to_end.hpp"

namespace tocsin::topic_tool {
namespace {

TEST(NodeProgram, SaysInOneLineThatANodeIsNotThere) {
  const Ended sut =
      run_to_end({NODE_PROGRAM, "info", "nobody", "--spin-time", "0.2", "--domain", "92"});
  EXPECT_EQ(sut.code, 1);
  EXPECT_THAT(sut.output, ::testing::HasSubstr("Unable to find node '/nobody'\n"));
  EXPECT_EQ(sut.output.find('\n'), sut.output.size() - 1) << sut.output;
}

}  // namespace
}  // namespace tocsin::topic_tool
