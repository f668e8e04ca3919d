// SPDX-License-Identifier: Apache-2.0
// When a LinkSender has room for stored samples.
#include <gtest/gtest.h>

#include "link_router/link_sender.hpp"

namespace tocsin::router {
namespace {

constexpr StreamId live = 1;
constexpr StreamId backfills = 100;

class BackfillRoomTest : public ::testing::Test {
 protected:
  BackfillRoomTest() {
    StreamRule rule;
    rule.name = "pose";
    rule.traffic_class = TrafficClass::high;
    sut_.add_stream(live, rule);
    sut_.add_backfill_stream(backfills);
    sut_.on_peer("station", 2, now_);
    for (const StreamId stream : {live, backfills}) {
      sut_.set_wanted("station", stream, true, now_);
    }
  }
  static Sample sample(std::uint64_t sequence, std::size_t bytes) {
    return {{7, sequence, {}}, bytes, nullptr};
  }
  /// Puts all of it on the wire. Returns in how many transmissions.
  std::size_t send(std::uint64_t sequence, std::size_t bytes) {
    const auto all = sut_.backfill(backfills, sample(sequence, bytes), now_);
    for (const Transmission& one : all) sut_.on_written(one, ++last_number_);
    return all.size();
  }
  Time now_{std::chrono::hours(1)};
  LinkSender sut_{LinkRouterParams{}};
  TransmissionNumber last_number_ = 0;
};

TEST_F(BackfillRoomTest, NothingGoesBeforeTheRadiosQueueIsEmpty) {
  EXPECT_TRUE(sut_.may_backfill(now_));
  sut_.offer(live, sample(1, 200), now_);
  EXPECT_FALSE(sut_.may_backfill(now_)) << "a live one waits";
  ASSERT_TRUE(sut_.next(now_));
  EXPECT_FALSE(sut_.may_backfill(now_)) << "it is in the radio";
  const Time opens = sut_.backfill_opens(now_);
  EXPECT_GT(opens, now_);
  EXPECT_FALSE(sut_.may_backfill(opens - Duration(1)));
  EXPECT_TRUE(sut_.may_backfill(opens));
}

TEST_F(BackfillRoomTest, OneGoesAtATime) {
  (void)sut_.backfill(backfills, sample(1, 200), now_);
  EXPECT_FALSE(sut_.may_backfill(now_));
  EXPECT_TRUE(sut_.may_backfill(sut_.backfill_opens(now_)));
}

TEST_F(BackfillRoomTest, ALargeOneWaitsForItsAcknowledgementThoughTheQueueIsEmpty) {
  EXPECT_TRUE(sut_.may_backfill(now_));
  EXPECT_EQ(send(1, 20'000), 17U) << "pieces";
  now_ += std::chrono::milliseconds(250);  // 0.22 s of the capacity
  EXPECT_FALSE(sut_.may_backfill(now_));
  EXPECT_EQ(sut_.backfill_opens(now_), never);
}

TEST_F(BackfillRoomTest, WhileNobodyAnswersOneGoesEachHalfSecond) {
  for (const std::uint64_t number : {1U, 2U, 3U}) {
    EXPECT_EQ(send(number, 200), 1U);
  }
  now_ += std::chrono::seconds(1);
  EXPECT_TRUE(sut_.may_backfill(now_));
  (void)sut_.backfill(backfills, sample(4, 200), now_);
  const Time next = now_ + std::chrono::milliseconds(500);
  EXPECT_EQ(sut_.backfill_opens(now_), next);
  EXPECT_FALSE(sut_.may_backfill(next - Duration(1)));
  EXPECT_TRUE(sut_.may_backfill(next));
}

}  // namespace
}  // namespace tocsin::router
