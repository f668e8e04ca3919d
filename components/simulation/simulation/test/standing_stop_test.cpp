// SPDX-License-Identifier: Apache-2.0
#include "simulation/standing_stop.hpp"

#include <gtest/gtest.h>

namespace tocsin::simulation {
namespace {

const Time t0 = Time{} + seconds(100);
constexpr Duration tick{1};

TopicEnd writer_of(const char* process) {
  TopicEnd end;
  end.host = "uxv";
  end.process = process;
  return end;
}

class StandingStopTest : public ::testing::Test {
 protected:
  StandingStop sut_;
  TopicEnd button_ = writer_of("button");
  TopicEnd other_ = writer_of("other");
};

TEST_F(StandingStopTest, StandsSinceTheRouterFirstReportedIt) {
  EXPECT_FALSE(sut_.since(t0));
  sut_.on_link(false, t0);
  EXPECT_FALSE(sut_.since(t0));
  sut_.on_link(true, t0 + tick);
  sut_.on_link(true, t0 + 2 * tick);
  EXPECT_EQ(sut_.since(t0 + 2 * tick), t0 + tick);
  EXPECT_EQ(sut_.since(t0 + seconds(60)), t0 + tick) << "silence does not end it";
  sut_.on_link(false, t0 + 3 * tick);
  EXPECT_FALSE(sut_.since(t0 + 3 * tick));
}

TEST_F(StandingStopTest, StandsWhenARouterFallsSilent) {
  sut_.on_link(false, t0);
  const Time silent = t0 + StandingStop::silent_after;
  EXPECT_FALSE(sut_.since(silent - tick));
  EXPECT_EQ(sut_.since(silent + seconds(5)), silent);
  sut_.on_link(false, silent + seconds(6));
  EXPECT_FALSE(sut_.since(silent + seconds(6)));
}

TEST_F(StandingStopTest, StandsUntilEachWriterHasReleasedItsOwn) {
  sut_.on_writer(button_, true, t0);
  sut_.on_writer(other_, true, t0 + tick);
  sut_.on_writer(button_, true, t0 + tick);
  EXPECT_EQ(sut_.since(t0 + tick), t0);
  sut_.on_writer(button_, false, t0 + tick);
  EXPECT_EQ(sut_.since(t0 + tick), t0 + tick);
  sut_.on_writer(other_, false, t0 + tick);
  EXPECT_FALSE(sut_.since(t0 + tick));
}

TEST_F(StandingStopTest, DoesNotCountTheStopOfAProcessThatHasEnded) {
  sut_.on_writer(button_, true, t0);
  sut_.on_process_ended("uxv/other");
  EXPECT_TRUE(sut_.since(t0));
  sut_.on_process_ended("uxv/button");
  EXPECT_FALSE(sut_.since(t0));
}

TEST_F(StandingStopTest, CountsFromTheStartOfAProcessThatMayBeTheDriver) {
  sut_.on_link(true, t0);
  sut_.on_process_started(t0 + seconds(3));
  EXPECT_EQ(sut_.since(t0 + seconds(4)), t0 + seconds(3));
}

TEST_F(StandingStopTest, ADriverThatBeginsExpectsTheRouterWithinASecond) {
  sut_.on_link(false, t0);
  sut_.on_process_started(t0 + seconds(0.5));
  const Time silent = t0 + seconds(0.5) + StandingStop::silent_after;
  EXPECT_FALSE(sut_.since(silent - tick));
  EXPECT_EQ(sut_.since(silent), silent);
}

}  // namespace
}  // namespace tocsin::simulation
