// SPDX-License-Identifier: Apache-2.0
#include "link_router/backfill_sender.hpp"
#include <gmock/gmock.h>
#include <optional>
#include <vector>

namespace tocsin::router {
namespace {

using sample_log::LogEntry;
using sample_log::Logged;
using sample_log::SampleId;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Time t0{std::chrono::hours(1)};
constexpr Duration ms = std::chrono::milliseconds(1);
constexpr double capacity_bytes_per_s = 1e6;

class BackfillSenderTest : public ::testing::Test {
 protected:
  [[nodiscard]] static SampleId id(std::uint64_t sequence, std::uint64_t source = 2,
                                   std::uint64_t stream = 1) {
    return {stream, source, sequence};
  }
  /// Goes to the log and does not cross.
  void miss(const SampleId& which) {
    sut_.offer(which);
    sut_.on_logged(which, Logged::kept);
    EXPECT_FALSE(sut_.on_fate(which, LiveFate::not_delivered));
  }
  void read_all(std::size_t bytes = 100) {
    for (auto wanted = sut_.take_wanted(); !wanted.empty(); wanted = sut_.take_wanted()) {
      std::vector<LogEntry> read;
      for (const SampleId& one : wanted) {
        read.push_back({one, 0, std::vector<std::uint8_t>(bytes)});
      }
      sut_.on_read(wanted, read);
    }
  }
  std::optional<BackfillBatch> next() { return sut_.next(now_, capacity_bytes_per_s); }
  [[nodiscard]] static std::vector<std::uint64_t> sequences(const BackfillBatch& batch) {
    std::vector<std::uint64_t> all;
    for (const LogEntry& entry : batch.samples) all.push_back(entry.id.sequence);
    return all;
  }
  [[nodiscard]] const StoredCounts& counts() const { return sut_.counts().at(1); }

  LinkRouterParams params_;
  BackfillSender sut_{params_};
  Time now_ = t0;
};

TEST_F(BackfillSenderTest, SendsWhatDidNotCrossOldestFirst) {
  sut_.begin_session();
  miss(id(1));
  miss(id(2));
  EXPECT_EQ(counts().waiting, 2U);
  read_all();
  const auto batch = next();
  ASSERT_TRUE(batch);
  EXPECT_THAT(sequences(*batch), ElementsAre(1, 2));
  EXPECT_EQ(batch->number, 1U);
  EXPECT_THAT(sut_.on_progress({batch->session, 1}, now_), ElementsAre(id(1), id(2)));
  EXPECT_EQ(counts().backfilled, 2U);
  EXPECT_EQ(counts().waiting, 0U);
  EXPECT_EQ(sut_.deadline(now_, capacity_bytes_per_s), never);
}

TEST_F(BackfillSenderTest, ABatchIsOfOneStreamAndOfBoundedSize) {
  sut_.begin_session();
  for (std::uint64_t i = 1; i <= 12; ++i) miss(id(i, 2, 1 + i % 2));
  read_all();
  const auto first = next();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->stream, 2U);
  EXPECT_THAT(sequences(*first), ElementsAre(1, 3, 5, 7, 9, 11));
  (void)sut_.on_progress({1, 1}, now_);
  for (std::uint64_t i = 21; i <= 40; ++i) miss(id(i));
  read_all();
  const auto second = next();
  ASSERT_TRUE(second);
  EXPECT_EQ(second->samples.size(), 7U) << "1100 B, of which 160 around all and 28 around each";
}

TEST_F(BackfillSenderTest, KeepsToItsShareOfTheCapacity) {
  sut_.begin_session();
  std::uint64_t sequence = 0;
  double bytes = 0;
  for (; now_ < t0 + 10'000 * ms; now_ += ms) {
    for (int i = 0; i < 3; ++i) miss(id(++sequence));
    read_all(600);
    while (const auto batch = next()) {
      bytes += 900;  // 600 B, what is around them, headers
      (void)sut_.on_progress({batch->session, batch->number}, now_);
    }
  }
  const double share = bytes / 10 / capacity_bytes_per_s;
  EXPECT_GT(share, 0.8 * params_.backfill_share);
  EXPECT_LE(share, 1.1 * params_.backfill_share);
}

TEST_F(BackfillSenderTest, HasAtMostEightUnconfirmed) {
  sut_.begin_session();
  for (std::uint64_t i = 1; i <= 20; ++i) miss(id(i));
  int sent = 0;
  for (int i = 0; i < 250; ++i, now_ += ms) {
    read_all(600);
    while (next()) ++sent;
  }
  EXPECT_EQ(sent, 8);
}

TEST_F(BackfillSenderTest, RepeatsTheFirstUntilItIsConfirmedAndEverMoreSeldom) {
  sut_.begin_session();
  miss(id(1));
  read_all();
  ASSERT_TRUE(next());
  std::vector<Duration> repeats;
  for (const Time begin = now_; now_ < begin + 6000 * ms; now_ += ms) {
    if (now_ < sut_.deadline(now_, capacity_bytes_per_s)) continue;
    const auto batch = next();
    ASSERT_TRUE(batch) << "it asked for it";
    EXPECT_EQ(batch->number, 1U);
    repeats.push_back(now_ - begin);
  }
  EXPECT_THAT(repeats, ElementsAre(300 * ms, 900 * ms, 2100 * ms, 4100 * ms));
  EXPECT_THAT(sut_.on_progress({1, 1}, now_), ElementsAre(id(1)));
}

TEST_F(BackfillSenderTest, KeepsAWritersOrderThoughTheLogIsReadAmidItsHistory) {
  sut_.begin_session();
  for (std::uint64_t i = 3; i <= 4; ++i) sut_.offer(id(i));
  for (std::uint64_t i = 1; i <= 6; ++i) sut_.recover(id(i));
  sut_.recover(id(9, 7));
  for (std::uint64_t i = 5; i <= 7; ++i) sut_.offer(id(i));
  for (const std::uint64_t i : {3, 4, 7})
    EXPECT_FALSE(sut_.on_fate(id(i), LiveFate::not_delivered));
  read_all(1);
  const auto batch = next();
  ASSERT_TRUE(batch);
  EXPECT_THAT(sequences(*batch), ElementsAre(1, 2, 9, 3, 4, 5, 6, 7));
}

TEST_F(BackfillSenderTest, CountsWhatTheLogCouldNotTake) {
  sut_.offer(id(1));
  sut_.on_logged(id(1), Logged::refused);
  EXPECT_FALSE(sut_.on_fate(id(1), LiveFate::delivered)) << "it is not in the log";
  EXPECT_EQ(counts().refused, 0U) << "it crossed";
  sut_.offer(id(2));
  sut_.on_logged(id(2), Logged::refused);
  EXPECT_FALSE(sut_.on_fate(id(2), LiveFate::not_delivered));
  EXPECT_EQ(counts().refused, 1U);
  sut_.offer(id(3));
  EXPECT_FALSE(sut_.on_fate(id(3), LiveFate::not_delivered));
  sut_.on_logged(id(3), Logged::refused);  // later than its fate
  EXPECT_EQ(counts().refused, 2U);
  EXPECT_EQ(counts().waiting, 0U);
}

TEST_F(BackfillSenderTest, WhatTheLogCannotReadIsCountedAndPassedOver) {
  sut_.begin_session();
  miss(id(1));
  miss(id(2));
  const auto wanted = sut_.take_wanted();
  sut_.on_read(wanted, {{id(2), 0, {}}});
  const auto batch = next();
  ASSERT_TRUE(batch);
  EXPECT_THAT(sequences(*batch), ElementsAre(2));
  EXPECT_EQ(counts().refused, 1U);
}

/// What is sent because somebody asked for it.
using BackfillRequestTest = BackfillSenderTest;

TEST_F(BackfillRequestTest, WhatIsRequestedGoesBehindWhatIsStored) {
  sut_.begin_session();
  sut_.request(id(1, 9, 5));
  sut_.request(id(2, 9, 5));
  sut_.request(id(1, 9, 5));  // known
  miss(id(7));
  EXPECT_THAT(sut_.take_wanted(), ElementsAre(id(7), id(1, 9, 5), id(2, 9, 5)));
}

TEST_F(BackfillRequestTest, WhatIsWithdrawnIsNotSent) {
  sut_.begin_session();
  for (std::uint64_t i = 1; i <= 3; ++i) sut_.request(id(i, 9, 5));
  miss(id(7));
  sut_.withdraw(id(2, 9, 5));
  sut_.withdraw(id(7));
  EXPECT_THAT(sut_.take_wanted(), ElementsAre(id(7), id(1, 9, 5), id(3, 9, 5)))
      << "what is stored cannot be withdrawn";
  sut_.on_read({id(7), id(1, 9, 5), id(3, 9, 5)},
               {{id(7), 0, {}}, {id(1, 9, 5), 0, {}}, {id(3, 9, 5), 0, {}}});
  ASSERT_TRUE(next());
  sut_.withdraw(id(3, 9, 5));
  const auto batch = next();
  ASSERT_TRUE(batch);
  EXPECT_THAT(sequences(*batch), ElementsAre(1));
  sut_.withdraw(id(1, 9, 5));
  EXPECT_THAT(sut_.on_progress({1, 2}, now_), ElementsAre(id(7), id(1, 9, 5)))
      << "it was under way";
}

}  // namespace
}  // namespace tocsin::router
