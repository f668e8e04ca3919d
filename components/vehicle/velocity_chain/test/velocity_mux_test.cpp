// SPDX-License-Identifier: Apache-2.0
#include "velocity_mux/velocity_mux.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

const Time t0 = Time{} + seconds(100);

VelocityMux make() { return VelocityMux({{"mission", 1, 0.5}, {"teleop", 5, 0.3}}); }

TEST(VelocityMux, IsIdleAtFirst) {
  VelocityMux sut = make();
  EXPECT_EQ(sut.active(), "idle");
  EXPECT_EQ(sut.next_deadline(), never);
  EXPECT_FALSE(sut.on_time(t0));
}

TEST(VelocityMux, PassesTheActiveSourceUnchanged) {
  VelocityMux sut = make();
  const auto out = sut.on_command("mission", {0.3, -0.2}, t0);
  ASSERT_TRUE(out);
  EXPECT_EQ(out->linear_mps, 0.3);
  EXPECT_EQ(out->angular_rad_s, -0.2);
  EXPECT_EQ(sut.active(), "mission");
}

TEST(VelocityMux, PrefersTheHigherPriorityAtOnce) {
  VelocityMux sut = make();
  (void)sut.on_command("mission", {0.3, 0}, t0);
  EXPECT_TRUE(sut.on_command("teleop", {0.1, 0}, t0));
  EXPECT_FALSE(sut.on_command("mission", {0.3, 0}, t0 + seconds(0.299)));
  EXPECT_EQ(sut.active(), "teleop");
}

TEST(VelocityMux, ReturnsToTheLowerPriorityAfterTheTimeout) {
  VelocityMux sut = make();
  (void)sut.on_command("teleop", {0.1, 0}, t0);
  EXPECT_TRUE(sut.on_command("mission", {0.3, 0}, t0 + seconds(0.3)));
  EXPECT_EQ(sut.active(), "mission");
}

TEST(VelocityMux, SendsZeroOnceWhenTheLastSourceFallsSilent) {
  VelocityMux sut = make();
  (void)sut.on_command("mission", {0.3, 0}, t0);
  EXPECT_FALSE(sut.on_time(t0 + seconds(0.499)));
  const auto out = sut.on_time(sut.next_deadline());
  ASSERT_TRUE(out);
  EXPECT_EQ(out->linear_mps, 0);
  EXPECT_EQ(sut.active(), "idle");
  EXPECT_FALSE(sut.on_time(t0 + seconds(10)));
}

TEST(VelocityMux, IgnoresUnknownSources) {
  VelocityMux sut = make();
  EXPECT_FALSE(sut.on_command("nobody", {1, 0}, t0));
}

TEST(VelocityMux, ChangesItsListWhileRunning) {
  VelocityMux sut = make();
  (void)sut.on_command("mission", {0.3, 0}, t0);
  sut.set_inputs({{"mission", 7, 2.0}, {"joy", 6, 0.3}});
  EXPECT_EQ(sut.active(), "mission");
  EXPECT_FALSE(sut.on_command("joy", {0.1, 0}, t0 + seconds(1)));  // its timeout is 2 s now
  EXPECT_FALSE(sut.on_command("teleop", {0.1, 0}, t0 + seconds(1)));
}

TEST(VelocityMux, StopsASourceThatWasRemoved) {
  VelocityMux sut = make();
  (void)sut.on_command("mission", {0.3, 0}, t0);
  sut.set_inputs({{"teleop", 5, 0.3}});
  ASSERT_TRUE(sut.on_time(t0));
  EXPECT_EQ(sut.active(), "idle");
}

TEST(VelocityMux, RefusesBadListsAndKeepsTheOld) {
  VelocityMux sut = make();
  EXPECT_THROW(sut.set_inputs({}), ConfigError);
  EXPECT_THROW(sut.set_inputs({{"a", 1, 1}, {"a", 2, 1}}), ConfigError);
  EXPECT_THROW(sut.set_inputs({{"a", 1, 1}, {"b", 1, 1}}), ConfigError);
  EXPECT_THROW(sut.set_inputs({{"a", 1, 0}}), ConfigError);
  EXPECT_TRUE(sut.on_command("mission", {0.3, 0}, t0));
}

TEST(VelocityMux, PassesNothingDuringAnEmergencyStop) {
  VelocityMux sut = make();
  (void)sut.on_command("mission", {0.3, 0}, t0);
  sut.on_emergency_stop(true);
  const auto out = sut.on_time(t0);
  ASSERT_TRUE(out);
  EXPECT_EQ(out->linear_mps, 0);
  EXPECT_FALSE(sut.on_command("teleop", {0.1, 0}, t0 + seconds(0.1)));
  EXPECT_EQ(sut.active(), "idle");
  sut.on_emergency_stop(false);
  EXPECT_TRUE(sut.on_command("teleop", {0.1, 0}, t0 + seconds(0.2)));
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
