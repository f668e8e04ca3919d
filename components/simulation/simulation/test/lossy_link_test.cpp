// SPDX-License-Identifier: Apache-2.0
// Writers and readers over a link that loses every third packet at random, with many seeds.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "rtps.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::simulation {
namespace {

using Picture = topic::CameraImage::Message;
using Sequences = std::vector<std::uint64_t>;

/// One writer and one reader on a lossy link of their own.
class LossyPair {
 public:
  LossyPair(const QosProfile& qos, std::uint64_t seed)
      : link_(core_, lossy(), {}, seed),
        writer_(RtpsWriter::make(core_, link_, {radio::Direction::uplink, 7, &end_, &origin_}, qos,
                                 nullptr)),
        reader_(RtpsReader::make(core_, link_, qos, [this](const Change& c, std::uint64_t) {
          got.push_back(c.sequence);
        })) {
    writer_->match(*reader_);
  }
  void write(std::size_t bytes) {
    Picture picture;
    picture.data().resize(bytes);
    ASSERT_TRUE(writer_->send(&picture));
  }
  void run_for(double s) {
    const Time end = core_.now + seconds(s);
    const auto next = [this] { return std::min(core_.events.next(), link_.next_event()); };
    for (Time at = next(); at <= end; at = next()) {
      core_.now = std::max(core_.now, at);
      core_.events.run(core_.now);
      link_.advance();
    }
    core_.now = end;
  }
  [[nodiscard]] std::uint64_t packets() const { return link_.pushed(); }
  Sequences got;

 private:
  static radio::ChannelParams lossy() {
    radio::ChannelParams params;
    params.mode = "bernoulli";
    params.loss = 1.0 / 3;
    return params;
  }
  static TopicEnd picture_end() {
    TopicEnd end;
    end.type = &type_info<Picture>();
    return end;
  }
  TopicEnd end_ = picture_end();
  Origin origin_;
  Core core_;
  RadioLink link_;
  std::unique_ptr<RtpsWriter> writer_;
  std::unique_ptr<RtpsReader> reader_;
};

QosProfile profile(const char* reliability, int depth) {
  QosProfile qos;
  qos.reliability = reliability;
  qos.depth = depth;
  return qos;
}

constexpr std::uint64_t seeds = 50;

TEST(LossyLink, ReliableDeepHistoryComesCompleteAndInOrder) {
  Sequences all(100);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i + 1;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    LossyPair sut(profile("reliable", 100), seed);
    for (std::size_t i = 0; i < all.size(); ++i) {
      sut.write(10);
      sut.run_for(0.05);
    }
    sut.run_for(30);
    EXPECT_EQ(sut.got, all) << "seed " << seed;
  }
}

TEST(LossyLink, ReliableKeepLastOneAlwaysEndsWithTheNewest) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    LossyPair sut(profile("reliable", 1), seed);
    for (int i = 0; i < 20; ++i) sut.write(10);
    sut.run_for(30);
    ASSERT_FALSE(sut.got.empty()) << "seed " << seed;
    EXPECT_EQ(sut.got.back(), 20U) << "seed " << seed;
    EXPECT_TRUE(std::is_sorted(sut.got.begin(), sut.got.end())) << "seed " << seed;
  }
}

TEST(LossyLink, ReliableLargeSampleComesWhole) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    LossyPair sut(profile("reliable", 1), seed);
    sut.write(4000);
    sut.run_for(120);
    EXPECT_EQ(sut.got, Sequences{1}) << "seed " << seed;
  }
}

TEST(LossyLink, BestEffortLosesTheShareOfTheLink) {
  LossyPair sut(profile("best_effort", 1), 1);
  for (int i = 0; i < 3000; ++i) sut.write(10);
  sut.run_for(1);
  EXPECT_NEAR(static_cast<double>(sut.got.size()), 2000, 100);  // four standard deviations
  EXPECT_EQ(sut.packets(), 3000U);
}

TEST(LossyLink, BestEffortSampleOfThreePacketsNeedsAllOfThem) {
  LossyPair sut(profile("best_effort", 1), 1);
  for (int i = 0; i < 3000; ++i) sut.write(3000);
  sut.run_for(1);
  EXPECT_EQ(sut.packets(), 9000U);
  EXPECT_NEAR(static_cast<double>(sut.got.size()), 3000 * 8.0 / 27, 100);
}

TEST(LossyLink, SilenceFollowsWhenEverythingIsAcknowledged) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    LossyPair sut(profile("reliable", 1), seed);
    sut.write(10);
    sut.run_for(30);
    const std::uint64_t packets = sut.packets();
    sut.run_for(30);
    EXPECT_EQ(sut.packets(), packets) << "seed " << seed;
  }
}

TEST(LossyLink, SameSeedCostsTheSamePacketsAndAnotherSeedOthers) {
  const auto run = [](std::uint64_t seed) {
    LossyPair sut(profile("reliable", 100), seed);
    for (int i = 0; i < 100; ++i) sut.write(100);
    sut.run_for(60);
    return sut.packets();
  };
  EXPECT_EQ(run(1), run(1));
  EXPECT_NE(run(1), run(2));
}

}  // namespace
}  // namespace tocsin::simulation
