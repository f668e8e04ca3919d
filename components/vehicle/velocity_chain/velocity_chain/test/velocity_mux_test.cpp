// SPDX-License-Identifier: Apache-2.0
#include "velocity_mux/velocity_mux.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

const Time t0 = Time{} + seconds(100);

VelocityMux make() { return VelocityMux({{"mission", 1, 0.5}, {"teleop", 5, 0.3}}); }

TEST(VelocityMux, RefusesBadListsAndKeepsTheOld) {
  VelocityMux sut = make();
  EXPECT_THROW(sut.set_inputs({}), ConfigError);
  EXPECT_THROW(sut.set_inputs({{"a", 1, 1}, {"a", 2, 1}}), ConfigError);
  EXPECT_THROW(sut.set_inputs({{"a", 1, 1}, {"b", 1, 1}}), ConfigError);
  EXPECT_THROW(sut.set_inputs({{"a", 1, 0}}), ConfigError);
  EXPECT_TRUE(sut.on_command("mission", {0.3, 0}, t0));
}

TEST(MuxInputs, AreReadAndWrittenInTheSameWords) {
  const std::string text = "teleop 30 0.5, navigation 10 0.25";
  const auto inputs = parse_inputs(text);
  ASSERT_EQ(inputs.size(), 2U);
  EXPECT_EQ(inputs[1].name, "navigation");
  EXPECT_EQ(inputs[1].priority, 10);
  EXPECT_EQ(inputs[1].timeout_s, 0.25);
  EXPECT_EQ(to_text(inputs), text);
}

TEST(MuxInputs, RefuseWordsThatAreNoInput) {
  for (const char* text : {"", ",", "teleop", "teleop high 1", "teleop 1 1 1", "teleop 1 nan",
                           "teleop 1 0", "teleop 1 61", "a 1 1, b 1 1"}) {
    EXPECT_THROW((void)parse_inputs(text), ConfigError) << text;
  }
}

}  // namespace
}  // namespace tocsin
