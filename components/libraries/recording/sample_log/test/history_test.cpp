// SPDX-License-Identifier: Apache-2.0
// A SampleLog that is used as a history.
#include <gmock/gmock.h>

#include <optional>
#include <string>

#include "sample_log/sample_log.hpp"

namespace tocsin::sample_log {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr Time began{std::chrono::hours(1)};
constexpr std::int64_t wall_began = 1'700'000'000'000'000'000;
constexpr std::int64_t second_ns = 1'000'000'000;

class HistoryTest : public ::testing::Test {
 protected:
  HistoryTest() { start(); }
  void start() {
    sut_.reset();
    sut_.emplace(files_, limits_, Instant{now_, wall_began + (now_ - began).count()},
                 LogUse::history);
    for (const char* const topic : {"odom", "image"}) {
      sut_->add({topic, "/" + std::string(topic), {0, "some_msgs/msg/Type", "", ""}, {}});
    }
  }
  [[nodiscard]] static SampleId id(std::uint64_t sequence, const std::string& topic = "odom") {
    return {stream_key(topic), 7, sequence};
  }
  void append(const SampleId& which, std::size_t bytes = 4) {
    const std::vector<std::uint8_t> content(bytes, static_cast<std::uint8_t>(which.sequence));
    EXPECT_EQ(
        sut_->append({{which, 1000, content}}, {now_, wall_began + (now_ - began).count()})[0],
        Logged::kept);
  }
  /// A sample of odom each second.
  void append_seconds(std::uint64_t first, std::uint64_t last, std::size_t bytes = 4) {
    for (std::uint64_t i = first; i <= last; ++i) {
      now_ = began + std::chrono::seconds(i);
      append(id(i), bytes);
    }
  }
  /// Seconds after the beginning, both included.
  [[nodiscard]] LogFinding find(std::int64_t from_s, std::int64_t to_s, std::size_t most = 4096) {
    return sut_->find({"/odom", static_cast<std::uint64_t>(wall_began + from_s * second_ns),
                       static_cast<std::uint64_t>(wall_began + to_s * second_ns), most});
  }
  MemoryFiles files_;
  LogLimits limits_;
  Time now_ = began;
  std::optional<SampleLog> sut_;
};

TEST_F(HistoryTest, FindsWhatCameInATimeInItsOrder) {
  append_seconds(1, 5);
  append(id(1, "image"));
  const LogFinding sut = find(2, 4);
  EXPECT_THAT(sut.ids, ElementsAre(id(2), id(3), id(4)));
  EXPECT_FALSE(sut.next_ns);
  const auto read = sut_->read(sut.ids);
  ASSERT_THAT(read, SizeIs(3));
  EXPECT_EQ(read[2].bytes, std::vector<std::uint8_t>(4, 4));
}

TEST_F(HistoryTest, WhatIsConfirmedIsNotFoundAgainAlsoAfterARestart) {
  append_seconds(1, 4);
  (void)find(1, 4);
  sut_->confirm({id(2), id(3)});
  EXPECT_THAT(find(1, 4).ids, ElementsAre(id(1), id(4)));
  start();
  EXPECT_THAT(sut_->waiting(), IsEmpty());
  EXPECT_THAT(find(1, 4).ids, ElementsAre(id(1), id(4)));
}

TEST_F(HistoryTest, ALongRangeIsFoundInParts) {
  limits_.bytes = 16'000;  // so that there are several segments
  start();
  append_seconds(1, 20, 100);
  std::vector<SampleId> all;
  std::int64_t from_ns = wall_began;
  for (int parts = 1; parts <= 4; ++parts) {
    const LogFinding sut = sut_->find({"/odom", static_cast<std::uint64_t>(from_ns),
                                       static_cast<std::uint64_t>(wall_began + 18 * second_ns), 5});
    all.insert(all.end(), sut.ids.begin(), sut.ids.end());
    ASSERT_EQ(sut.next_ns.has_value(), parts < 4);
    if (sut.next_ns) from_ns = static_cast<std::int64_t>(*sut.next_ns);
  }
  ASSERT_THAT(all, SizeIs(18));
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i], id(i + 1));
}

TEST_F(HistoryTest, ASampleThatCameTwiceIsInItOnceAlsoAfterARestart) {
  append_seconds(1, 2);
  for (int lives = 0; lives < 2; ++lives, start()) {
    EXPECT_EQ(sut_->append({{id(2), 1000, {1}}}, {now_, wall_began})[0], Logged::waiting);
  }
  EXPECT_EQ(sut_->contents().at(0).samples, 2U);
  EXPECT_THAT(find(0, 9).ids, ElementsAre(id(1), id(2)));
}

TEST_F(HistoryTest, TellsWhatItHasOfEachTopic) {
  EXPECT_THAT(sut_->contents(), IsEmpty());
  append_seconds(3, 9);
  append(id(1, "image"));
  for (int lives = 0; lives < 2; ++lives, start()) {
    const auto sut = sut_->contents();
    ASSERT_THAT(sut, SizeIs(2));
    EXPECT_EQ(sut[0].topic, "/image");
    EXPECT_EQ(sut[0].samples, 1U);
    EXPECT_EQ(sut[1].topic, "/odom");
    EXPECT_EQ(sut[1].samples, 7U);
    EXPECT_EQ(sut[1].first_ns, static_cast<std::uint64_t>(wall_began + 3 * second_ns));
    EXPECT_EQ(sut[1].last_ns, static_cast<std::uint64_t>(wall_began + 9 * second_ns));
  }
}

TEST_F(HistoryTest, TheOldestGoesBeyondTheBoundsAndWhatWasAskedForIsTold) {
  limits_.bytes = 16'000;
  start();
  append_seconds(1, 100, 300);
  (void)find(1, 3);
  const auto gone = sut_->retire(now_);
  EXPECT_THAT(gone, ElementsAre(id(1), id(2), id(3)));
  EXPECT_LE(sut_->bytes(), limits_.bytes);
  EXPECT_GT(sut_->contents().at(0).first_ns,
            static_cast<std::uint64_t>(wall_began + 3 * second_ns));
  EXPECT_THAT(find(1, 3).ids, IsEmpty());
  EXPECT_THAT(find(99, 100).ids, SizeIs(2));
}

TEST_F(HistoryTest, ADamagedSegmentCostsItsSamplesOnly) {
  limits_.bytes = 16'000;
  start();
  append_seconds(1, 20, 300);
  ASSERT_GT(files_.names().size(), 3U);
  files_.bytes_of("segment.00000001.mcap").assign(8, 0);
  const LogFinding sut = find(1, 20);
  EXPECT_FALSE(sut.ids.empty());
  EXPECT_EQ(sut.ids.back(), id(20));
  EXPECT_THAT(sut_->take_problems(), ElementsAre(HasSubstr("segment.00000001")));
}

}  // namespace
}  // namespace tocsin::sample_log
