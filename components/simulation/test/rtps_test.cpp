// SPDX-License-Identifier: Apache-2.0
#include "rtps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>

#include "tocsin_idl/topics.hpp"

namespace tocsin::simulation {
namespace {

using Message = topic::EmergencyStop::Message;
constexpr double delay_s = 0.01;

QosProfile best_effort() {
  QosProfile qos;
  qos.reliability = "best_effort";
  return qos;
}

QosProfile reliable(int depth) {
  QosProfile qos;
  qos.depth = depth;
  return qos;
}

QosProfile state() {
  QosProfile qos;
  qos.durability = "transient_local";
  return qos;
}

/// A writer, a reader and the link between them, which is dead from 10 s to 15 s.
class RtpsTest : public ::testing::Test {
 protected:
  RtpsTest() {
    radio::ChannelParams params;
    params.mode = "bernoulli";
    params.delay_s = delay_s;
    params.outages_s = {10, 5};
    link_ = std::make_unique<RadioLink>(core_, params, std::vector<radio::Wall>{}, 1);
  }
  void use(const QosProfile& qos) {
    end_.type = &type_info<Message>();
    const RtpsWriter::Owner owner{radio::Direction::downlink, 7, &end_, &origin_};
    writer_ = std::make_unique<RtpsWriter>(core_, *link_, owner, qos);
    reader_ = std::make_unique<RtpsReader>(qos, [this](const Change& change, std::uint64_t source) {
      EXPECT_EQ(source, 7U);
      got_.push_back(change.sequence);
      got_at_ = core_.now;
    });
  }
  void connect(const QosProfile& qos) {
    use(qos);
    writer_->match(*reader_);
  }
  void write(int count = 1) {
    for (int i = 0; i < count; ++i) ASSERT_TRUE(writer_->send(&message_));
  }
  /// Until `s` seconds after the start.
  void run_until(double s) {
    const Time end = start_time + seconds(s);
    const auto next = [this] { return std::min(core_.events.next(), link_->next_event()); };
    for (Time at = next(); at <= end; at = next()) {
      core_.now = std::max(core_.now, at);
      core_.events.run(core_.now);
      link_->advance();
    }
    core_.now = end;
  }

  using Sequences = std::vector<std::uint64_t>;
  Core core_;
  Message message_;
  std::unique_ptr<RadioLink> link_;
  TopicEnd end_;
  Origin origin_;
  std::unique_ptr<RtpsWriter> writer_;
  std::unique_ptr<RtpsReader> reader_;
  Sequences got_;
  Time got_at_{};
};

TEST_F(RtpsTest, SampleArrivesAfterTheDelayOfTheLink) {
  connect(best_effort());
  write();
  EXPECT_TRUE(got_.empty());
  run_until(1);
  EXPECT_EQ(got_, Sequences{1});
  EXPECT_EQ(got_at_, start_time + seconds(delay_s));
}

TEST_F(RtpsTest, BestEffortSampleOfADeadLinkIsLost) {
  connect(best_effort());
  run_until(11);
  write();
  run_until(30);
  write();
  run_until(31);
  EXPECT_EQ(got_, Sequences{2});
}

TEST_F(RtpsTest, BestEffortCostsOnePacketPerSample) {
  connect(best_effort());
  write(5);
  run_until(9);
  EXPECT_EQ(link_->pushed(), 5U);
}

TEST_F(RtpsTest, ReliableSampleOfADeadLinkIsRepaired) {
  connect(reliable(1));
  run_until(11);
  write();
  run_until(14.9);
  EXPECT_TRUE(got_.empty());
  run_until(15.5);
  EXPECT_EQ(got_, Sequences{1});
}

TEST_F(RtpsTest, RepairGivesWhatTheHistoryHoldsInOrder) {
  connect(reliable(3));
  run_until(11);
  write(5);
  run_until(16);
  EXPECT_EQ(got_, (Sequences{3, 4, 5}));
}

TEST_F(RtpsTest, KeepLastOneRepairsTheNewestOnly) {
  connect(reliable(1));
  run_until(11);
  write(3);
  run_until(16);
  EXPECT_EQ(got_, Sequences{3});
}

TEST_F(RtpsTest, ReliableReaderWaitsForEarlierSamples) {
  connect(reliable(10));
  run_until(14.99);
  write();  // lost
  run_until(15.01);
  write();  // arrives before the first is repaired
  run_until(15.1);
  EXPECT_TRUE(got_.empty());
  run_until(16);
  EXPECT_EQ(got_, (Sequences{1, 2}));
}

TEST_F(RtpsTest, ReliabilityCostsOneHeartbeatAndOneAnswerWhenNothingIsLost) {
  connect(reliable(1));
  write();
  run_until(9);
  EXPECT_EQ(link_->pushed(), 3U);
}

TEST_F(RtpsTest, HeartbeatsGoOnWhileNobodyAnswers) {
  connect(reliable(1));
  run_until(11);
  write();
  run_until(12.1);
  EXPECT_EQ(link_->pushed(), 6U);  // the sample and one heartbeat each 0.2 s
}

TEST_F(RtpsTest, SampleBeyondItsLifespanIsNotRepaired) {
  QosProfile qos = reliable(1);
  qos.lifespan_s = 2;
  connect(qos);
  run_until(11);
  write();
  run_until(13.5);
  const std::uint64_t packets = link_->pushed();
  run_until(20);
  EXPECT_TRUE(got_.empty());
  EXPECT_EQ(link_->pushed(), packets);
}

TEST_F(RtpsTest, SampleWithinItsLifespanIsRepaired) {
  QosProfile qos = reliable(1);
  qos.lifespan_s = 2;
  connect(qos);
  run_until(14);
  write();
  run_until(20);
  EXPECT_EQ(got_, Sequences{1});
}

TEST_F(RtpsTest, SampleThatArrivesAfterItsLifespanIsDropped) {
  QosProfile qos = best_effort();
  qos.lifespan_s = delay_s / 2;
  connect(qos);
  write();
  run_until(1);
  EXPECT_TRUE(got_.empty());
}

TEST_F(RtpsTest, SilencedWriterSendsNeitherDataNorHeartbeat) {
  connect(reliable(1));
  run_until(11);
  write();
  writer_->silence();
  const std::uint64_t packets = link_->pushed();
  run_until(30);
  EXPECT_EQ(link_->pushed(), packets);
  EXPECT_TRUE(got_.empty());
}

TEST_F(RtpsTest, WriterThatWasSilencedGoesOnWithTheNextSample) {
  connect(reliable(1));
  run_until(11);
  write();
  writer_->silence();
  run_until(16);
  write();
  run_until(17);
  EXPECT_EQ(got_, Sequences{2});
}

TEST_F(RtpsTest, LateReaderGetsTheLastStateRepairedWhenLost) {
  use(state());
  write(2);
  run_until(11);
  writer_->match(*reader_);
  run_until(14);
  EXPECT_TRUE(got_.empty());
  run_until(16);
  EXPECT_EQ(got_, Sequences{2});
}

TEST_F(RtpsTest, LateReaderOfAVolatileTopicGetsNewSamplesOnly) {
  use(reliable(1));
  write();
  run_until(1);
  writer_->match(*reader_);
  run_until(2);
  EXPECT_TRUE(got_.empty());
  write();
  run_until(3);
  EXPECT_EQ(got_, Sequences{2});
}

TEST(RtpsReader, SkipsAGap) {
  std::vector<std::uint64_t> got;
  RtpsReader sut(reliable(10), [&](const Change& c, std::uint64_t) { got.push_back(c.sequence); });
  const auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  sut.match(7, 1);
  sut.on_data(7, {2, start_time, bytes}, start_time);
  EXPECT_EQ(sut.on_heartbeat(7, 1, 2, start_time), std::vector<std::uint64_t>{1});
  EXPECT_TRUE(got.empty());
  sut.on_gap(7, 1, start_time);
  EXPECT_EQ(got, std::vector<std::uint64_t>{2});
}

TEST(RtpsReader, GivesADuplicateOnce) {
  int got = 0;
  RtpsReader sut(reliable(10), [&](const Change&, std::uint64_t) { ++got; });
  const auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  sut.match(7, 1);
  for (int i = 0; i < 2; ++i) sut.on_data(7, {1, start_time, bytes}, start_time);
  EXPECT_EQ(got, 1);
}

TEST(WirePackets, KeepASmallSampleWhole) {
  EXPECT_EQ(wire::packets_of(100), std::vector<std::size_t>{28 + 20 + 12 + 24 + 60 + 100});
  EXPECT_EQ(wire::packets_of(1224), std::vector<std::size_t>{1368});
}

TEST(WirePackets, CutALargeSample) {
  EXPECT_EQ(wire::packets_of(1225).size(), 2U);
  const auto packets = wire::packets_of(10'000);
  EXPECT_EQ(*std::max_element(packets.begin(), packets.end()), 1396U);
  const std::size_t headers = packets.size() * (28 + 36 + 12 + 36 + 60);
  EXPECT_EQ(std::accumulate(packets.begin(), packets.end(), std::size_t{0}), 10'000 + headers);
}

}  // namespace
}  // namespace tocsin::simulation
