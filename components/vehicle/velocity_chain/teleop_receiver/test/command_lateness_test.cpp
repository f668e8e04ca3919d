// SPDX-License-Identifier: Apache-2.0
#include "teleop_receiver/command_lateness.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t t0 = 1'800'000'000'000 * ms;

struct Lateness : ::testing::Test {
  /// A command that is received `at_ms` after the start, `delay_ms` after it was sent.
  bool fresh(std::int64_t at_ms, std::int64_t delay_ms) {
    const std::int64_t received = t0 + at_ms * ms;
    return sut.is_fresh(received - delay_ms * ms + offset_ns, received);
  }
  CommandLateness sut{std::chrono::milliseconds(500)};
  std::int64_t offset_ns = 0;  ///< of the sender's clock
};

TEST_F(Lateness, TellsLateFromFreshAtItsLimit) {
  EXPECT_TRUE(fresh(0, 20));
  EXPECT_TRUE(fresh(100, 520));
  EXPECT_FALSE(fresh(200, 521));
  EXPECT_TRUE(fresh(300, 20));
}

TEST_F(Lateness, DoesNotMindClocksThatDiffer) {
  for (const std::int64_t hours : {-5, 5}) {
    sut = CommandLateness(std::chrono::milliseconds(500));
    offset_ns = hours * 3'600'000 * ms;
    EXPECT_TRUE(fresh(0, 20));
    EXPECT_TRUE(fresh(100, 400));
    EXPECT_FALSE(fresh(200, 600));
  }
}

TEST_F(Lateness, FollowsClocksThatDriftForHours) {
  bool all_fresh = true;
  for (std::int64_t i = 0; i < 36'000 * 5; ++i) {
    offset_ns = -i * 100 * 200;  // 200 ppm: 3.6 s in five hours
    all_fresh = all_fresh && fresh(i * 100, 20);
  }
  EXPECT_TRUE(all_fresh);
}

TEST_F(Lateness, LearnsAnewAfterAPause) {
  EXPECT_TRUE(fresh(0, 20));
  offset_ns = -10'000 * ms;  // a clock was set meanwhile
  EXPECT_TRUE(fresh(70'000, 20));
}

TEST_F(Lateness, KeepsItsYardstickForHalfAMinute) {
  EXPECT_TRUE(fresh(0, 20));
  for (std::int64_t at = 100; at <= 30'000; at += 100) EXPECT_FALSE(fresh(at, 600)) << at;
}

}  // namespace
}  // namespace tocsin
