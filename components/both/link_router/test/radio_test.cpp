// SPDX-License-Identifier: Apache-2.0
// The router over the model of a Wi-Fi radio with one queue: both sides of the cliff that repair
// stands on, and the way back from an outage.
#include <gtest/gtest.h>

#include "radio_pair.hpp"

namespace tocsin::router {
namespace {

constexpr Duration ms = std::chrono::milliseconds(1);

/// A busy channel with people who move, as in config/radio/thesis_b.yaml, at a place of this mean
/// SNR.
radio::ChannelParams busy_place(double snr_db) {
  radio::ChannelParams params;
  params.shadowing_sigma_db = 0;
  params.rician_k_clear_db = 4;
  params.environment_doppler_hz = 2;
  params.tx_dbm = 0;
  params.loss_at_1m_db = 40;
  params.noise_dbm = -40 - snr_db;
  params.background_load = 0.64;
  params.background_frame_s = 0.001;
  return params;
}

StreamRule rule_of(TrafficClass traffic_class) {
  StreamRule rule;
  rule.traffic_class = traffic_class;
  rule.repaired = policy_of(traffic_class).repaired;
  return rule;
}

/// Critical topics of a vehicle, its location and small low ones.
void add_traffic(RadioPair& pair) {
  for (int i = 0; i < 8; ++i) {
    pair.add(rule_of(TrafficClass::critical), 200, 200 * ms, (10 + 23 * i) * ms);
  }
  pair.add(rule_of(TrafficClass::high), 420, 200 * ms, 5 * ms);
  pair.add(rule_of(TrafficClass::low), 200, 500 * ms, 7 * ms);
}

/// Share of critical samples that were late, over three seeds of 40 s.
double late_critical(const LinkRouterParams& params, double snr_db) {
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    RadioPair pair(busy_place(snr_db), params, seed);
    add_traffic(pair);
    pair.run(std::chrono::seconds(40));
    for (StreamId stream = 0; stream < 8; ++stream) sum += pair.late_share(stream, 250 * ms) / 24;
  }
  return sum;
}

constexpr double poor_snr_db = 6;

TEST(Radio, RepairAtItsDefaultsHelpsAtAPoorPlace) {
  LinkRouterParams without;
  without.repair_share = 0;
  const double lost = late_critical(without, poor_snr_db);
  EXPECT_GT(lost, 0.12) << "the place is poor";
  EXPECT_LT(late_critical({}, poor_snr_db), lost / 3);
}

TEST(Radio, RepairEveryTwentyMillisecondsTipsTheLinkOver) {
  LinkRouterParams hasty;
  hasty.repair_first_s = 0.02;
  hasty.repair_backoff = 1;
  hasty.repair_share = 1;
  const double usual = late_critical({}, poor_snr_db);
  EXPECT_LT(usual, 0.045);
  EXPECT_GT(late_critical(hasty, poor_snr_db), 2 * usual);
}

TEST(Radio, AFreshSampleCrossesWithinASecondOfAnOutagesEnd) {
  for (const int length_s : {2, 10, 40}) {
    RadioPair pair(busy_place(20), {}, 1);
    add_traffic(pair);
    pair.run(std::chrono::seconds(5));
    pair.radio.begin_outage(pair.now, std::chrono::seconds(length_s));
    pair.run(std::chrono::seconds(length_s));
    const Time back = pair.now;
    pair.run(std::chrono::seconds(3));
    for (const StreamId stream : {0U, 8U, 9U}) {  // critical, high, low
      EXPECT_LT(pair.first_arrival(stream, back), back + std::chrono::seconds(1))
          << "stream " << stream << " after " << length_s << " s";
    }
  }
}

// The mean of ten seeds: of one, the first share is anything from 0.01 to 0.06.
TEST(Radio, PicturesHarmNoCriticalSampleBeyondTheirOwnLength) {
  constexpr int seeds = 10;
  double late = 0;
  double very_late = 0;
  double late_pictures = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    RadioPair pair(busy_place(14), {}, seed);
    add_traffic(pair);
    StreamRule camera = rule_of(TrafficClass::low);
    camera.adaptive = true;
    pair.add(camera, 15000, 125 * ms, 60 * ms);
    pair.run(std::chrono::seconds(60));
    late += pair.late_share(0, 100 * ms) / seeds;
    very_late += pair.late_share(0, 250 * ms) / seeds;
    late_pictures += pair.late_share(10, 1000 * ms) / seeds;
  }
  EXPECT_LT(late, 0.04);
  EXPECT_LT(very_late, 0.01);
  EXPECT_LT(late_pictures, 0.05) << "and the pictures arrive";
}

}  // namespace
}  // namespace tocsin::router
