// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/trace.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"
#include "radio_channel/radio_channel.hpp"

namespace tocsin::radio {
namespace {

const double none = std::nan("");
const Time t0{std::chrono::hours(1)};

TEST(Trace, IsStraightBetweenItsPoints) {
  const Trace sut({{10, -40, 0.02}, {12, -60, 0.02}});
  EXPECT_DOUBLE_EQ(sut.length_s(), 2);
  EXPECT_DOUBLE_EQ(sut.rssi_dbm(0), -40);
  EXPECT_DOUBLE_EQ(sut.rssi_dbm(0.5), -45);
}

TEST(Trace, BeginsAgainAfterItsEnd) {
  const Trace sut({{0, -40, 0.02}, {2, -60, 0.02}});
  EXPECT_DOUBLE_EQ(sut.rssi_dbm(2.5), -45);
  EXPECT_DOUBLE_EQ(sut.rssi_dbm(-1.5), -45);
}

TEST(Trace, TakesHalfOfTheDelayForEachWay) {
  const Trace sut({{0, -40, 0.08}, {1, -40, none}, {2, -40, 0.02}});
  EXPECT_DOUBLE_EQ(sut.one_way_s(0.5), 0.04);
  EXPECT_DOUBLE_EQ(sut.one_way_s(1.5), 0);
}

TEST(Trace, IsDeadOnlyWhenNothingAnsweredForLongerThanTwoSeconds) {
  const Trace lost({{0, -40, 0.02}, {1, -40, none}, {3, -40, 0.02}, {9, -40, 0.02}});
  EXPECT_FALSE(lost.dead(2));
  const Trace dead({{0, -40, 0.02}, {1, -40, none}, {3.1, -40, 0.02}, {9, -40, 0.02}});
  EXPECT_TRUE(dead.dead(2));
  EXPECT_FALSE(dead.dead(0.5));
  EXPECT_FALSE(dead.dead(3.1));
}

TEST(Trace, RejectsWhatIsNoTrace) {
  EXPECT_THROW(Trace({{0, -40, 0.02}}), ConfigError);
  EXPECT_THROW(Trace({{0, -40, 0.02}, {0, -50, 0.02}}), ConfigError);
  EXPECT_THROW(Trace({{0, -40, 0.02}, {2, -50, 0.02}, {1, -50, 0.02}}), ConfigError);
  EXPECT_THROW(Trace({{0, none, 0.02}, {2, -50, 0.02}}), ConfigError);
}

ChannelParams replay(std::vector<TracePoint> points) {
  ChannelParams params;
  params.trace = std::make_shared<const Trace>(std::move(points));
  params.trace_random_start = false;
  return params;
}

TEST(Replay, FollowsTheTraceAndNotThePosition) {
  RadioChannel sut(replay({{0, -40, 0}, {100, -90, 0}}), {}, 1, t0);
  sut.set_position(500, 500);
  EXPECT_NEAR(sut.report(t0 + seconds(50)).mean_snr_db, -65 + 94, 0.01);
}

TEST(Replay, BeginsWhereTheSeedSays) {
  ChannelParams params = replay({{0, -40, 0}, {100, -90, 0}});
  params.trace_random_start = true;
  RadioChannel one(params, {}, 1, t0);
  RadioChannel same(params, {}, 1, t0);
  RadioChannel other(params, {}, 2, t0);
  EXPECT_EQ(one.report(t0).mean_snr_db, same.report(t0).mean_snr_db);
  EXPECT_NE(one.report(t0).mean_snr_db, other.report(t0).mean_snr_db);
}

/// When a packet of the vehicle that was sent at `at` arrived; empty: never.
std::optional<Time> arrival(RadioChannel& channel, Time at) {
  channel.push(Direction::uplink, {100}, at);
  channel.advance(at + seconds(1));
  const auto outcome = channel.take();
  if (!outcome || outcome->fate != Fate::delivered) return std::nullopt;
  return outcome->at;
}

TEST(Replay, DelaysAsMeasured) {
  RadioChannel sut(replay({{0, -40, 0.2}, {100, -40, 0.2}}), {}, 1, t0);
  const auto at = arrival(sut, t0 + seconds(1));
  ASSERT_TRUE(at);
  EXPECT_NEAR(to_seconds(*at - t0), 1.1, 0.01);
}

TEST(Replay, DeliversNothingWhileTheMeasuredLinkWasDead) {
  RadioChannel sut(replay({{0, -40, 0}, {10, -40, none}, {20, -40, 0}, {30, -40, 0}}), {}, 1, t0);
  EXPECT_TRUE(arrival(sut, t0 + seconds(5)));
  EXPECT_FALSE(arrival(sut, t0 + seconds(12)));
  EXPECT_TRUE(arrival(sut, t0 + seconds(22)));
}

}  // namespace
}  // namespace tocsin::radio
