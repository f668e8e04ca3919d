// SPDX-License-Identifier: Apache-2.0
// Several vehicles on one channel.
#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include "link_simulation.hpp"

namespace tocsin::radio {
namespace {

constexpr double length_s = 4;

/// What each of the vehicles gets through [Mbit/s] when all always have packets of 1500 bytes.
/// `far_x_m`: where the first one stands; the others are beside the access point.
std::vector<double> saturate(const ChannelParams& params, std::size_t vehicles,
                             double far_x_m = 0) {
  RadioChannel channel(params, {}, 1, Time{}, vehicles);
  channel.set_position(far_x_m, 0, 0);
  for (double t_s = 0; t_s < length_s; t_s += 0.01) {
    for (std::size_t i = 0; i < vehicles; ++i) {
      const LinkReport report = channel.report(Time{} + seconds(t_s), i);
      for (std::size_t queued = report.uplink.queued; queued < 40; ++queued) {
        channel.push(Direction::uplink, {1500, false, AccessCategory::best_effort, i},
                     Time{} + seconds(t_s));
      }
    }
    while (channel.take()) {
    }
  }
  std::vector<double> mbps;
  for (std::size_t i = 0; i < vehicles; ++i) {
    const LinkReport report = channel.report(Time{} + seconds(length_s), i);
    mbps.push_back(static_cast<double>(report.uplink.bytes_delivered) * 8 / length_s / 1e6);
  }
  return mbps;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

ChannelParams near_by(const std::string& data_rate) {
  ChannelParams params = place(60, 60);
  params.data_rate = data_rate;
  params.attempts = 31;  // Bianchi's stations never give up a frame
  params.queue_frames = 200;
  params.wire_delay_s = 0;
  return params;
}

struct Reference {
  const char* data_rate;
  std::size_t vehicles;
  double total_mbps;
};

// ns-3, src/wifi/examples/wifi-bianchi.cc, table bianchiResultsEifs of 802.11g.
constexpr Reference references[] = {{"6", 5, 4.69},    {"6", 10, 4.32},   {"6", 20, 3.96},
                                    {"6", 50, 3.47},   {"24", 5, 16.08},  {"24", 10, 14.92},
                                    {"24", 20, 13.73}, {"24", 50, 12.09}, {"54", 5, 29.29},
                                    {"54", 10, 27.38}, {"54", 20, 25.33}, {"54", 50, 22.42}};

TEST(SharedMedium, SaturatesAsBianchiAndNs3Say) {
  for (const Reference& one : references) {
    const double total = sum(saturate(near_by(one.data_rate), one.vehicles));
    EXPECT_NEAR(total, one.total_mbps, 0.05 * one.total_mbps)
        << one.data_rate << " Mbit/s, " << one.vehicles << " vehicles";
  }
}

TEST(SharedMedium, GivesEqualVehiclesEqualShares) {
  const auto each = saturate(near_by("24"), 5);
  for (const double mbps : each) EXPECT_NEAR(mbps, sum(each) / 5, 0.1 * sum(each) / 5);
}

// Heusse et al., "Performance anomaly of 802.11b", INFOCOM 2003: who sends slowly takes the time of
// all, and each gets as little as the slow one.
TEST(SharedMedium, OneFarVehicleSlowsAll) {
  ChannelParams params = place(40, 60);
  params.queue_frames = 200;
  const auto near = saturate(params, 3);
  const auto with_far = saturate(params, 3, 30);  // 29 dB less
  EXPECT_LT(with_far[1], 0.7 * near[1]);
  EXPECT_GT(with_far[0], 0);
}

// Hoiland-Jorgensen et al., "Ending the Anomaly", USENIX ATC 2017: the access point's turns are of
// equal time, not of equal packets.
TEST(SharedMedium, WhatIsForAFarVehicleDoesNotHoldUpWhatIsForTheOthers) {
  ChannelParams params = place(40, 60);
  params.wire_delay_s = 0;
  RadioChannel channel(params, {}, 1, Time{}, 2);
  channel.set_position(40, 0, 0);  // hardly anything gets there
  for (int i = 0; i < 300; ++i) {
    const Time now = Time{} + seconds(0.01 * i);
    for (const std::size_t vehicle : {0u, 0u, 0u, 1u}) {
      channel.push(Direction::downlink, {1400, false, AccessCategory::best_effort, vehicle}, now);
    }
  }
  channel.advance(Time{} + seconds(3.1));
  const auto near = channel.report(Time{} + seconds(3.1), 1).downlink;
  EXPECT_GT(channel.report(Time{} + seconds(3.1), 0).downlink.queue_drops, 100u);
  EXPECT_EQ(near.queue_drops, 0u);
  EXPECT_GT(near.delivered, 290u);
}

TEST(SharedMedium, AFrameThatHasWaitedTooLongIsGivenUp) {
  ChannelParams params = near_by("6");
  params.frame_lifetime_s = 0.1;
  RadioChannel channel(params, {}, 1, Time{}, 1);
  for (int i = 0; i < 150; ++i) channel.push(Direction::uplink, {1500}, Time{});
  channel.advance(Time{} + seconds(1));
  Time last{};
  int given_up = 0;
  while (const auto outcome = channel.take()) {
    if (outcome->fate == Fate::delivered) last = outcome->at;
    given_up += outcome->fate == Fate::lost_in_queue ? 1 : 0;
  }
  EXPECT_NEAR(to_seconds(last - Time{}), 0.1, 0.01);
  EXPECT_GT(given_up, 90);  // 44 of 2.3 ms each are in time
  EXPECT_EQ(channel.report(Time{} + seconds(1)).uplink.queued, 0u);
}

TEST(SharedMedium, VehiclesAtOnePlaceShareItsShadowingAndNotTheFading) {
  ChannelParams params;
  params.rician_k_clear_db = 0;
  RadioChannel channel(params, {}, 1, Time{}, 2);
  for (const std::size_t vehicle : {0u, 1u}) channel.set_position(7, 3, vehicle);
  EXPECT_EQ(channel.propagation(0).mean_rssi_dbm(), channel.propagation(1).mean_rssi_dbm());
  for (const std::size_t vehicle : {0u, 1u}) (void)channel.report(Time{} + seconds(1), vehicle);
  EXPECT_NE(channel.report(Time{} + seconds(2), 0).rssi_dbm,
            channel.report(Time{} + seconds(2), 1).rssi_dbm);
}

TEST(SharedMedium, TellsOfEachPacketWhoseItWas) {
  RadioChannel channel(near_by("adaptive"), {}, 1, Time{}, 3);
  for (const Direction direction : {Direction::uplink, Direction::downlink}) {
    channel.push(direction, {200, false, AccessCategory::voice, 2}, Time{});
  }
  channel.advance(Time{} + seconds(1));
  EXPECT_EQ(channel.take()->vehicle, 2u);
  EXPECT_EQ(channel.take()->vehicle, 2u);
  EXPECT_EQ(channel.report(Time{} + seconds(1), 2).uplink.delivered, 1u);
  EXPECT_EQ(channel.report(Time{} + seconds(1), 2).downlink.delivered, 1u);
  EXPECT_EQ(channel.report(Time{} + seconds(1), 0).uplink.pushed, 0u);
}

TEST(SharedMedium, WithoutMacEachVehicleHasALineOfItsOwn) {
  ChannelParams params;
  params.mode = "bernoulli";
  params.rate_mbit_s = 1;
  RadioChannel channel(params, {}, 1, Time{}, 2);
  for (const std::size_t vehicle : {0u, 1u}) {
    channel.push(Direction::uplink, {1250, false, AccessCategory::best_effort, vehicle}, Time{});
  }
  channel.advance(Time{} + seconds(1));
  const Time expected = Time{} + seconds(0.01 + params.delay_s);
  EXPECT_EQ(channel.take()->at, expected);
  EXPECT_EQ(channel.take()->at, expected);
}

}  // namespace
}  // namespace tocsin::radio
