// SPDX-License-Identifier: Apache-2.0
#include "sample_log/log_follower.hpp"

#include <gmock/gmock.h>

#include <optional>
#include <string>
#include <vector>

namespace tocsin::sample_log {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using From = LogStart::From;

constexpr Time began{std::chrono::hours(1)};
constexpr std::int64_t wall_began = 1'700'000'000'000'000'000;
constexpr std::int64_t second_ns = 1'000'000'000;

/// A history that is written while it is read.
class LogFollowerTest : public ::testing::Test {
 protected:
  LogFollowerTest() { start(); }
  /// The next life of who writes it; the last one closed nothing.
  void start() {
    log_.reset();
    log_.emplace(files_, limits_, Instant{now_, wall_ns()}, LogUse::history);
    for (const char* const topic : {"odom", "image"}) {
      log_->add({topic, "/" + std::string(topic), {0, "some_msgs/msg/Type", "", ""}, {{"k", "v"}}});
    }
  }
  [[nodiscard]] std::int64_t wall_ns() const { return wall_began + (now_ - began).count(); }
  void append(std::uint64_t sequence, const std::string& topic = "odom", std::size_t bytes = 4) {
    const std::vector<std::uint8_t> content(bytes, static_cast<std::uint8_t>(sequence));
    (void)log_->append({{{stream_key(topic), 7, sequence}, 1000, content}}, {now_, wall_ns()});
  }
  /// A sample of odom each second.
  void append_seconds(std::uint64_t first, std::uint64_t last, std::size_t bytes = 4) {
    for (std::uint64_t i = first; i <= last; ++i) {
      now_ = began + std::chrono::seconds(i);
      append(i, "odom", bytes);
    }
  }
  void follow(const LogStart& from, const std::string& topic = "/odom") {
    sut_.emplace(files_, topic, from);
  }
  std::vector<std::uint64_t> read(std::size_t most = 1000) {
    std::vector<std::uint64_t> sequences;
    for (const LogSample& one : sut_->read(most)) sequences.push_back(one.id.sequence);
    return sequences;
  }
  MemoryFiles files_;
  LogLimits limits_;
  Time now_ = began;
  std::optional<SampleLog> log_;
  std::optional<LogFollower> sut_;
};

TEST_F(LogFollowerTest, GivesTheOldestFirstAndThenWhatComes) {
  append_seconds(1, 3);
  append(1, "image");
  follow({From::beginning});
  EXPECT_THAT(read(), ElementsAre(1, 2, 3));
  EXPECT_THAT(read(), IsEmpty());
  append_seconds(4, 5);
  EXPECT_THAT(read(), ElementsAre(4, 5));
}

TEST_F(LogFollowerTest, TellsAllThatTheLogKnowsOfASample) {
  append_seconds(1, 1);
  follow({From::beginning});
  const auto came = sut_->read(1);
  ASSERT_EQ(came.size(), 1U);
  EXPECT_EQ(came[0].id, (SampleId{stream_key("odom"), 7, 1}));
  EXPECT_EQ(came[0].stream->topic, "/odom");
  EXPECT_EQ(came[0].stream->schema.name, "some_msgs/msg/Type");
  EXPECT_EQ(came[0].stream->facts.at("k"), "v");
  EXPECT_EQ(came[0].place, static_cast<std::uint64_t>(wall_began + second_ns));
  EXPECT_EQ(came[0].sent_wall_ns, 1000);
  EXPECT_EQ(came[0].bytes, std::vector<std::uint8_t>(4, 1));
}

TEST_F(LogFollowerTest, BeginsWithTheNextThatComes) {
  append_seconds(1, 3);
  follow({});
  EXPECT_THAT(read(), IsEmpty());
  append_seconds(4, 4);
  EXPECT_THAT(read(), ElementsAre(4));
}

TEST_F(LogFollowerTest, BeginsWithTheLastOfItsTopicAlsoOverSeveralSegments) {
  limits_.bytes = 16 * 2000;
  start();
  append_seconds(1, 20, 900);
  append(1, "image");
  follow({From::last, 3});
  EXPECT_THAT(read(), ElementsAre(18, 19, 20));
  follow({From::last, 1000});
  EXPECT_EQ(read().size(), 20U);
  follow({From::last, 0});
  EXPECT_THAT(read(), IsEmpty());
}

TEST_F(LogFollowerTest, GoesOnWhereAnotherWas) {
  append_seconds(1, 5);
  follow({From::beginning});
  EXPECT_THAT(read(2), ElementsAre(1, 2));
  follow({From::after, sut_->place()});
  EXPECT_THAT(read(), ElementsAre(3, 4, 5));
  EXPECT_FALSE(sut_->take_gap());
}

TEST_F(LogFollowerTest, FollowsTheLogOverSegmentsAndLives) {
  limits_.bytes = 16 * 2000;
  start();
  append_seconds(1, 7, 900);
  follow({From::beginning});
  EXPECT_EQ(read().size(), 7U);
  start();
  append_seconds(8, 9, 900);
  EXPECT_THAT(read(), ElementsAre(8, 9));
}

TEST_F(LogFollowerTest, TellsOnceThatRetentionTookWhatItHadNotRead) {
  limits_.bytes = 16 * 2000;
  start();
  append_seconds(1, 2, 900);
  follow({From::beginning});
  EXPECT_THAT(read(1), ElementsAre(1));
  const LogStart was{From::after, sut_->place()};
  append_seconds(3, 200, 900);
  (void)log_->retire(now_);
  const auto rest = read();
  EXPECT_GT(rest.front(), 2U);
  EXPECT_EQ(rest.back(), 200U);
  EXPECT_TRUE(sut_->take_gap());
  EXPECT_FALSE(sut_->take_gap());
  follow(was);
  EXPECT_TRUE(sut_->take_gap()) << "also for who comes back";
  EXPECT_EQ(read(), rest);
  follow({From::beginning});
  EXPECT_FALSE(sut_->take_gap()) << "who wants what there is misses nothing";
}

TEST_F(LogFollowerTest, WhatWasReadBeforeRetentionTookItIsNoGap) {
  limits_.age = std::chrono::seconds(10);
  start();
  append_seconds(1, 2);
  start();
  append_seconds(3, 3);
  follow({From::beginning});
  EXPECT_EQ(read().size(), 3U);
  now_ += std::chrono::seconds(9);
  (void)log_->retire(now_ + std::chrono::milliseconds(500));
  append_seconds(20, 20);
  EXPECT_THAT(read(), ElementsAre(20));
  EXPECT_FALSE(sut_->take_gap());
}

TEST_F(LogFollowerTest, LeavesADamagedSampleOutAndCountsIt) {
  append_seconds(1, 1, 500);
  const std::size_t first = files_.size();
  append_seconds(2, 3, 500);
  files_.bytes_of(files_.names().back())[first + 200] ^= 0xff;
  follow({From::beginning});
  EXPECT_THAT(read(), ElementsAre(1, 3));
  EXPECT_EQ(sut_->damaged(), 1U);
}

}  // namespace
}  // namespace tocsin::sample_log
