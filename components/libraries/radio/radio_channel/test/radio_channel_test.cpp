// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/radio_channel.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"
#include "link_simulation.hpp"

namespace tocsin::radio {
namespace {

const ChannelParams good = place(40, 60);
constexpr Time begin{};

ChannelParams without_mac(double loss) {
  ChannelParams params = good;
  params.mode = "bernoulli";
  params.loss = loss;
  return params;
}

/// Pushes bursts of random packets both ways for 20 s while the station moves.
void play_random_traffic(LinkSimulation& link, std::uint64_t seed) {
  RandomStream random(seed, 99);
  for (double t_s = 0; t_s < 20; t_s += random.exponential(0.005)) {
    link.channel.set_position(10 + t_s, 3);
    const Direction direction = random.chance(0.5) ? Direction::uplink : Direction::downlink;
    for (int burst = random.below(8); burst > 0; --burst) {
      const bool is_group = random.chance(0.1);
      link.push(direction, 40 + random.below(1460), t_s, is_group);
    }
  }
  link.finish();
}

ChannelParams rough(const std::string& mode) {
  ChannelParams params;
  params.mode = mode;
  params.tx_dbm = -15;
  params.background_load = 0.3;
  params.loss = 0.2;
  params.outages_s = {5, 1};
  return params;
}

TEST(RadioChannel, ALineWithoutMacCarriesItsRateEachWayAndDropsWhatItsQueueDoesNotHold) {
  ChannelParams params;
  params.mode = "bernoulli";
  params.rate_mbit_s = 1;  // 12 ms for 1500 bytes
  params.delay_s = 0.03;
  params.queue_frames = 10;
  RadioChannel sut(params, {}, 1, begin);
  for (int i = 0; i < 20; ++i) (void)sut.push(Direction::uplink, {1500}, begin);
  (void)sut.push(Direction::downlink, {1500}, begin);
  sut.advance(begin + seconds(10));
  int dropped = 0;
  std::vector<double> up_s;
  std::vector<double> down_s;
  while (const auto outcome = sut.take()) {
    if (outcome->fate == Fate::lost_in_queue) {
      ++dropped;
    } else {
      (outcome->direction == Direction::uplink ? up_s : down_s)
          .push_back(to_seconds(outcome->at - begin));
    }
  }
  EXPECT_EQ(dropped, 9);
  ASSERT_EQ(up_s.size(), 11U);
  EXPECT_NEAR(up_s.front(), 0.042, 1e-6);
  EXPECT_NEAR(up_s.back(), 0.03 + 11 * 0.012, 1e-6);
  ASSERT_EQ(down_s.size(), 1U);
  EXPECT_NEAR(down_s.front(), 0.042, 1e-6) << "not behind the other way";
}

TEST(RadioChannel, JitterKeepsTheOrderOfAWay) {
  ChannelParams params;
  params.mode = "bernoulli";
  params.delay_s = 0.02;
  params.jitter_s = 0.01;
  RadioChannel sut(params, {}, 1, begin);
  std::vector<FrameId> sent;
  for (int i = 0; i < 1000; ++i) {
    sent.push_back(sut.push(Direction::uplink, {100}, begin + std::chrono::milliseconds(i)));
  }
  sut.advance(begin + seconds(10));
  std::vector<FrameId> came;
  double least_s = 1;
  double most_s = 0;
  while (const auto outcome = sut.take()) {
    const double delay_s =
        to_seconds(outcome->at - begin) - 0.001 * static_cast<double>(came.size());
    came.push_back(outcome->id);
    least_s = std::min(least_s, delay_s);
    most_s = std::max(most_s, delay_s);
  }
  EXPECT_EQ(came, sent);
  EXPECT_NEAR(least_s, 0.02, 0.01);
  EXPECT_NEAR(most_s, 0.03, 0.001);
}

TEST(RadioChannel, EndsEveryPacketExactlyOnceInEveryMode) {
  for (const char* mode : {"radio", "bernoulli", "gilbert_elliott"}) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      LinkSimulation link(rough(mode), seed);
      play_random_traffic(link, seed);
      const LinkReport report = link.channel.report(Time{} + seconds(60));
      EXPECT_EQ(link.repeated, 0);
      EXPECT_EQ(link.outcomes.size(), report.uplink.pushed + report.downlink.pushed) << mode;
      for (const DirectionReport& d : {report.uplink, report.downlink}) {
        EXPECT_EQ(d.pushed, d.delivered + d.queue_drops + d.losses);
        EXPECT_GT(d.delivered, 0u);
        EXPECT_GT(d.losses, 0u);
      }
    }
  }
}

/// FNV-1a over how and when each packet ended, and over what the stations did on the air.
std::uint64_t digest_of(LinkSimulation& link) {
  std::uint64_t digest = 14695981039346656037u;
  const auto add = [&digest](std::uint64_t value) { digest = (digest ^ value) * 1099511628211u; };
  for (const auto& [id, outcome] : link.outcomes) {
    add(id);
    add(static_cast<std::uint64_t>(outcome.fate));
    add(static_cast<std::uint64_t>(outcome.at.time_since_epoch().count()));
  }
  const LinkReport report = link.channel.report(Time{} + seconds(60));
  for (const AirCounters& air : {report.uplink.air, report.downlink.air}) {
    add(air.retries);
    add(static_cast<std::uint64_t>(air.airtime.count()));
  }
  return digest;
}

// Recorded experiments are compared with new ones, so the single queue keeps every bit.
TEST(RadioChannel, WithoutAccessCategoriesRunsAreTheSameToTheLastBit) {
  for (const auto& [seed, known] : {std::pair{1, 7583525114634292637ULL},
                                    {2, 7103105187859776492ULL},
                                    {3, 3050539753018686038ULL}}) {
    LinkSimulation link(rough("radio"), static_cast<std::uint64_t>(seed));
    play_random_traffic(link, static_cast<std::uint64_t>(seed));
    EXPECT_EQ(digest_of(link), known) << seed;
  }
}

TEST(RadioChannel, DoesNotDependOnHowOftenItIsAdvanced) {
  LinkSimulation coarse(rough("radio"));
  LinkSimulation fine(rough("radio"));
  for (int i = 0; i < 200; ++i) {
    coarse.push(Direction::uplink, 1400, 0.002 * i);
    fine.push(Direction::uplink, 1400, 0.002 * i);
    for (int k = 1; k < 20; ++k) fine.run_until(0.002 * i + 0.0001 * k);
  }
  coarse.finish();
  fine.finish();
  for (const auto& [id, outcome] : coarse.outcomes) EXPECT_EQ(fine.outcomes.at(id).at, outcome.at);
}

TEST(RadioChannel, AdvancesFromOutcomeToOutcomeWithinTheLimit) {
  LinkSimulation stepped(rough("radio"));
  LinkSimulation sut(rough("radio"));
  for (int i = 0; i < 50; ++i) {
    stepped.push(Direction::uplink, 1400, 0);
    sut.push(Direction::uplink, 1400, 0);
  }
  stepped.finish();
  const Time limit = Time{} + seconds(0.02);
  std::size_t count = 0;
  for (Time at{}; (at = sut.channel.advance_to_outcome(limit)) != limit;) {
    const FrameId id = sut.channel.first_outcome().id;
    EXPECT_EQ(stepped.outcomes.at(id).at, at);
    EXPECT_EQ(sut.channel.advance_to_outcome(limit), at);  // until it is taken
    EXPECT_EQ(sut.channel.take()->id, id);
    ++count;
  }
  EXPECT_GT(count, 0u);
  EXPECT_LT(count, 50u);
  EXPECT_GE(sut.channel.next_event(), limit);
}

TEST(RadioChannel, DropsTheTailOfAQueueOfOneHundred) {
  LinkSimulation link(good);
  for (int i = 0; i < 130; ++i) link.push(Direction::uplink, 1000, 0);
  EXPECT_EQ(link.count(Fate::lost_in_queue), 30);
  EXPECT_EQ(link.outcomes.begin()->first, 101u);  // the tail, not the head
  link.finish();
  EXPECT_EQ(link.count(Fate::delivered), 100);
}

TEST(RadioChannel, HasAQueueForEachDirection) {
  LinkSimulation link(good);
  for (int i = 0; i < 100; ++i) link.push(Direction::uplink, 1000, 0);
  for (int i = 0; i < 100; ++i) link.push(Direction::downlink, 1000, 0);
  link.finish();
  EXPECT_EQ(link.count(Fate::lost_in_queue), 0);
}

TEST(RadioChannel, AddsTheWireOnceInEachDirection) {
  ChannelParams slow = good;
  slow.wire_delay_s = 0.1;
  for (const Direction direction : {Direction::uplink, Direction::downlink}) {
    LinkSimulation link(slow);
    const FrameId id = link.push(direction, 100, 1.0);
    link.finish();
    EXPECT_NEAR(to_seconds(link.outcomes.at(id).at), 1.1, 0.001);
  }
}

TEST(RadioChannel, IsAtRestWithoutPackets) {
  const LinkSimulation link(good);
  EXPECT_EQ(link.channel.next_event(), never);
}

TEST(RadioChannel, WithoutMacDelaysByAConstantAndNeverQueues) {
  LinkSimulation link(without_mac(0));
  for (int i = 0; i < 1000; ++i) link.push(Direction::uplink, 1500, 2.0);
  link.finish();
  EXPECT_EQ(link.count(Fate::delivered), 1000);
  for (const auto& [id, outcome] : link.outcomes) EXPECT_EQ(outcome.at, Time{} + seconds(2.001));
}

TEST(RadioChannel, ReceivesNothingInAScriptedOutage) {
  for (const char* mode : {"radio", "bernoulli"}) {
    ChannelParams params = without_mac(0);
    params.mode = mode;
    params.outages_s = {10, 5, 20, 1};
    LinkSimulation link(params);
    const auto arrives = [&link](double at_s) {
      const FrameId id = link.push(Direction::uplink, 100, at_s);
      link.finish();
      return link.outcomes.at(id).fate == Fate::delivered;
    };
    EXPECT_TRUE(arrives(9.9));
    EXPECT_FALSE(arrives(10.0));
    EXPECT_FALSE(arrives(14.9));
    EXPECT_TRUE(arrives(15.0));
    EXPECT_FALSE(arrives(20.5));
    EXPECT_TRUE(arrives(21.0));
  }
}

TEST(RadioChannel, LosesAssociationInAnOutageAndFindsItAgain) {
  LinkSimulation link(good);
  const auto associated = [&link](double at_s) {
    return link.channel.report(Time{} + seconds(at_s)).associated;
  };
  EXPECT_TRUE(associated(1.0));
  link.channel.begin_outage(Time{} + seconds(1.0), seconds(20));
  EXPECT_TRUE(associated(1.5));
  EXPECT_FALSE(associated(2.0));
  EXPECT_FALSE(associated(20.9));
  EXPECT_TRUE(associated(21.2));
}

TEST(RadioChannel, RejectsOutagesThatAreNotPairsInOrder) {
  ChannelParams params = good;
  params.outages_s = {1};
  EXPECT_THROW(RadioChannel(params, {}, 1, Time{}), ConfigError);
  params.outages_s = {1, 2, 2.9, 1};
  EXPECT_THROW(RadioChannel(params, {}, 1, Time{}), ConfigError);
  params.outages_s = {1, 2, 3, 1};
  EXPECT_NO_THROW(RadioChannel(params, {}, 1, Time{}));
}

TEST(RadioChannel, ReportsSignalAndQualityAsTheKernelWould) {
  ChannelParams params = good;
  params.tx_dbm = -25;  // received with -65 dBm
  LinkSimulation link(params);
  const LinkReport report = link.channel.report(Time{} + seconds(1));
  EXPECT_NEAR(report.rssi_dbm, -65, 0.05);
  EXPECT_EQ(report.quality, 45);
  EXPECT_EQ(report.noise_dbm, params.noise_dbm);
}

TEST(LinkQuality, IsClampedSignalPlus110) {
  const std::pair<double, int> known[] = {{-35, 70}, {-40, 70},  {-45, 65}, {-60, 50}, {-75, 35},
                                          {-90, 20}, {-100, 10}, {-110, 0}, {-120, 0}};
  for (const auto& [rssi_dbm, quality] : known) EXPECT_EQ(link_quality(rssi_dbm), quality);
  EXPECT_EQ(link_quality(std::nan("")), 0);
}

TEST(RadioChannel, ReportsTheBusyShareSinceTheLastReport) {
  ChannelParams params = good;
  params.background_load = 0.2;
  LinkSimulation link(params);
  for (int i = 0; i < 1000; ++i) link.push(Direction::uplink, 1500, 0.001 * i);
  const double own = 0.302;  // 258 + 10 + 34 us in every millisecond
  EXPECT_NEAR(link.channel.report(Time{} + seconds(1)).busy_share, 0.2 + own, 0.05);
  EXPECT_NEAR(link.channel.report(Time{} + seconds(2)).busy_share, 0.2, 0.01);
}

TEST(RadioChannel, ConfiguresWhatIsSentFromNowOn) {
  LinkSimulation link(good);
  link.channel.set_position(0.5, 0.5);
  link.push(Direction::uplink, 100, 1);  // still on the air when the mode changes
  ChannelParams params = without_mac(1);
  link.channel.configure(params);
  const FrameId second = link.push(Direction::uplink, 100, 2);
  link.finish();
  EXPECT_EQ(link.outcomes.at(1).fate, Fate::delivered);
  EXPECT_EQ(link.outcomes.at(second).fate, Fate::lost_on_air);
  EXPECT_EQ(link.channel.propagation().x_m(), 0.5);
}

TEST(RadioChannel, MeetsTheSameRadioWhateverTheTraffic) {
  LinkSimulation silent(rough("radio"), 3);
  LinkSimulation busy(rough("radio"), 3);
  play_random_traffic(busy, 3);
  silent.channel.set_position(12, 3);
  busy.channel.set_position(12, 3);
  EXPECT_EQ(silent.channel.propagation().mean_rssi_dbm(),
            busy.channel.propagation().mean_rssi_dbm());
}

}  // namespace
}  // namespace tocsin::radio
