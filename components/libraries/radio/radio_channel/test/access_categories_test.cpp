// SPDX-License-Identifier: Apache-2.0
// Access categories as seen through the channel: who goes first, who still gets through.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "link_simulation.hpp"

namespace tocsin::radio {
namespace {

using Category = AccessCategory;

ChannelParams with_categories(ChannelParams params) {
  params.access_categories = true;
  return params;
}

const ChannelParams clear = with_categories(place(40, 60));

ChannelParams rough() {
  ChannelParams params;
  params.tx_dbm = -15;
  params.background_load = 0.3;
  params.outages_s = {5, 1};
  return with_categories(params);
}

/// 40 Mbit/s of packets of 1500 bytes in each of `categories`, more than the channel carries.
void offer(LinkSimulation& link, const std::vector<Category>& categories, double length_s,
           Direction direction = Direction::uplink) {
  for (double t_s = 0; t_s < length_s; t_s += 0.0003) {
    for (const Category one : categories) link.push(direction, Packet{1500, false, one}, t_s);
  }
}

double mbps(const DirectionReport& report, Category category, double length_s) {
  const auto& counts = report.categories[static_cast<std::size_t>(category)];
  return static_cast<double>(counts.delivered) * 1500 * 8 / length_s / 1e6;
}

/// The longest time that a packet of 100 bytes of `category` took, one every 20 ms, while the queue
/// of `other` is full.
double longest_wait_s(const ChannelParams& params, Category category, Category other) {
  LinkSimulation link(params);
  std::vector<std::pair<FrameId, double>> probes;
  for (double t_s = 0; t_s < 5; t_s += 0.0003) {
    link.push(Direction::uplink, Packet{1500, false, other}, t_s);
    const double next_s = 0.5 + 0.02 * static_cast<double>(probes.size());
    if (t_s < next_s) continue;
    probes.emplace_back(link.push(Direction::uplink, Packet{100, false, category}, t_s), t_s);
  }
  link.finish();
  double longest_s = 0;
  for (const auto& [id, sent_s] : probes) {
    const Outcome& outcome = link.outcomes.at(id);
    if (outcome.fate != Fate::delivered) return 1e9;
    longest_s = std::max(longest_s, to_seconds(outcome.at.time_since_epoch()) - sent_s);
  }
  return longest_s;
}

TEST(AccessCategories, AFullQueueOfTheBackgroundDoesNotDelayVoice) {
  // One frame of 0.3 ms is on the air; 5 ms is a dozen retries.
  EXPECT_LT(longest_wait_s(clear, Category::voice, Category::background), 0.005);
  EXPECT_LT(longest_wait_s(clear, Category::video, Category::background), 0.01);
  EXPECT_LT(longest_wait_s(clear, Category::voice, Category::best_effort), 0.005);
}

TEST(AccessCategories, WithoutThemVoiceWaitsBehindTheFullQueue) {
  ChannelParams params = clear;
  params.access_categories = false;
  EXPECT_GT(longest_wait_s(params, Category::voice, Category::background), 0.02);
}

// As in 802.11e: voice waits 55 us at most, and the background 73 us at least.
TEST(AccessCategories, AFullQueueOfVoiceStarvesTheBackgroundOfItsStation) {
  LinkSimulation link(clear);
  offer(link, {Category::voice, Category::background}, 5);
  const DirectionReport report = link.channel.report(Time{} + seconds(5)).uplink;
  EXPECT_GT(mbps(report, Category::voice, 5), 34);
  EXPECT_LT(mbps(report, Category::background, 5), 0.1);
}

TEST(AccessCategories, TheBackgroundGetsThroughBesideUrgentTrafficThatLeavesRoom) {
  LinkSimulation link(clear);
  for (double t_s = 0; t_s < 5; t_s += 0.001) {
    link.push(Direction::uplink, Packet{500, false, Category::voice}, t_s);
    link.push(Direction::uplink, Packet{200, false, Category::background}, t_s);
  }
  link.finish();
  EXPECT_EQ(link.count(Fate::delivered), static_cast<int>(link.outcomes.size()));
}

TEST(AccessCategories, SaturatedStationsShareByUrgency) {
  LinkSimulation link(clear);
  offer(link, {Category::video, Category::best_effort, Category::background}, 5);
  const DirectionReport report = link.channel.report(Time{} + seconds(5)).uplink;
  const double video = mbps(report, Category::video, 5);
  const double best_effort = mbps(report, Category::best_effort, 5);
  const double background = mbps(report, Category::background, 5);
  EXPECT_GT(video, 2 * best_effort);
  EXPECT_GT(best_effort, background);
  EXPECT_GT(background, 0);
  EXPECT_NEAR(video + best_effort + background, 31, 3);  // what one queue carries: 30.2
}

TEST(AccessCategories, OneSaturatedCategoryCarriesAsMuchAsItsBackoffLeaves) {
  // 258 us data, 44 us acknowledgement; idle time and mean backoff: voice 28 + 13.5 us, background
  // 73 + 67.5 us.
  LinkSimulation voice(clear);
  offer(voice, {Category::voice}, 5);
  EXPECT_NEAR(mbps(voice.channel.report(Time{} + seconds(5)).uplink, Category::voice, 5), 34.9,
              0.3);
  LinkSimulation background(clear);
  offer(background, {Category::background}, 5);
  EXPECT_NEAR(mbps(background.channel.report(Time{} + seconds(5)).uplink, Category::background, 5),
              27.1, 0.3);
}

TEST(AccessCategories, CategoriesOfOneStationNeverCollideOnTheAir) {
  LinkSimulation link(clear);
  offer(link, {Category::voice, Category::video, Category::best_effort, Category::background}, 3);
  const LinkReport report = link.channel.report(Time{} + seconds(3));
  EXPECT_EQ(report.uplink.air.retries, 0u);
  EXPECT_GT(report.uplink.air.attempts, 5000u);
}

TEST(AccessCategories, TheAirIsNeverUsedByTwoAtOnce) {
  ChannelParams params = clear;
  params.wire_delay_s = 0;
  LinkSimulation link(params, 3);
  offer(link, {Category::voice, Category::video, Category::best_effort, Category::background}, 1);
  link.finish();
  // Without losses each frame and its acknowledgement take the same time; no two end closer.
  const Duration frame = frame_duration(7, 1500 + mac_overhead_bytes);
  std::vector<Time> ends;
  for (const auto& [id, outcome] : link.outcomes) {
    if (outcome.fate == Fate::delivered) ends.push_back(outcome.at);
  }
  std::sort(ends.begin(), ends.end());
  ASSERT_GT(ends.size(), 1000u);
  for (std::size_t i = 1; i < ends.size(); ++i) EXPECT_GE(ends[i] - ends[i - 1], frame + difs);
}

/// Bursts of random packets of all categories both ways for 20 s while the station moves.
void play(LinkSimulation& link, std::uint64_t seed) {
  RandomStream random(seed, 98);
  for (double t_s = 0; t_s < 20; t_s += random.exponential(0.005)) {
    link.channel.set_position(10 + t_s, 3);
    const Direction direction = random.chance(0.5) ? Direction::uplink : Direction::downlink;
    for (int burst = random.below(12); burst > 0; --burst) {
      const Category category = access_categories[static_cast<std::size_t>(random.below(4))];
      link.push(direction, Packet{40 + random.below(1460), random.chance(0.1), category}, t_s);
    }
  }
}

TEST(AccessCategories, EveryPacketEndsExactlyOnceAndIsCountedInItsCategory) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    LinkSimulation link(rough(), seed);
    play(link, seed);
    link.finish();
    const LinkReport report = link.channel.report(Time{} + seconds(60));
    EXPECT_EQ(link.repeated, 0);
    EXPECT_EQ(link.outcomes.size(), report.uplink.pushed + report.downlink.pushed);
    for (const DirectionReport& direction : {report.uplink, report.downlink}) {
      PacketCounts sum;
      for (const PacketCounts& one : direction.categories) {
        EXPECT_EQ(one.pushed, one.delivered + one.queue_drops + one.losses);
        EXPECT_GT(one.delivered, 0u);
        sum.pushed += one.pushed;
        sum.delivered += one.delivered;
      }
      EXPECT_EQ(sum.pushed, direction.pushed);
      EXPECT_EQ(sum.delivered, direction.delivered);
      EXPECT_EQ(direction.queued, 0u);
    }
  }
}

TEST(AccessCategories, DeliverInOrderWithinACategory) {
  LinkSimulation link(rough(), 4);
  play(link, 4);
  link.finish();
  Time last[2][4] = {};
  for (const auto& [id, outcome] : link.outcomes) {
    if (outcome.fate != Fate::delivered) continue;
    Time& before = last[outcome.direction == Direction::uplink ? 0 : 1]
                       [static_cast<std::size_t>(outcome.category)];
    EXPECT_GE(outcome.at, before);
    before = outcome.at;
  }
}

TEST(AccessCategories, EachHasAQueueOfItsOwn) {
  LinkSimulation link(clear);
  for (int i = 0; i < 130; ++i)
    link.push(Direction::uplink, Packet{1000, false, Category::video}, 0);
  for (int i = 0; i < 100; ++i)
    link.push(Direction::uplink, Packet{1000, false, Category::voice}, 0);
  EXPECT_EQ(link.count(Fate::lost_in_queue), 30);
  EXPECT_EQ(link.channel.report(Time{}).uplink.queued, 200u);
  link.finish();
  EXPECT_EQ(link.count(Fate::delivered), 200);
}

TEST(AccessCategories, AreSwitchedWhilePacketsWait) {
  LinkSimulation link(clear);
  ChannelParams single = clear;
  single.access_categories = false;
  for (const bool on : {false, true, false}) {
    link.channel.configure(on ? clear : single);
    for (const Category one : access_categories) {
      for (int i = 0; i < 10; ++i) link.push(Direction::uplink, Packet{1000, false, one}, 0.001);
    }
  }
  link.finish();
  EXPECT_EQ(link.count(Fate::delivered), 120);
  EXPECT_EQ(link.channel.report(Time{} + seconds(9)).uplink.queued, 0u);
}

TEST(AccessCategories, BestEffortAloneIsLikeTheSingleQueue) {
  // One slot more of idle time; loss and delay are otherwise the same link.
  double loss[2] = {};
  for (const bool on : {false, true}) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      ChannelParams params = place(8, 3);
      params.access_categories = on;
      loss[on ? 1 : 0] += ping_loss(params, seed, 300) / 5;
    }
  }
  EXPECT_NEAR(loss[0], loss[1], 0.02);
}

}  // namespace
}  // namespace tocsin::radio
