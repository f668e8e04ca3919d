// SPDX-License-Identifier: Apache-2.0
// When a LinkSender has room for stored samples.
#include <gtest/gtest.h>

#include "link_router/link_sender.hpp"

namespace tocsin::router {
namespace {

constexpr StreamId live = 1;
constexpr StreamId fill_ins = 100;

class FillInRoomTest : public ::testing::Test {
 protected:
  FillInRoomTest() {
    StreamRule rule;
    rule.name = "pose";
    rule.traffic_class = TrafficClass::high;
    sut_.add_stream(live, rule);
    sut_.add_fill_in_stream(fill_ins);
    sut_.on_peer("station", 2, now_);
    for (const StreamId stream : {live, fill_ins}) {
      sut_.set_wanted("station", stream, true, now_);
    }
  }
  static Sample sample(std::uint64_t sequence, std::size_t bytes) {
    return {{7, sequence, {}}, bytes, nullptr};
  }
  Time now_{std::chrono::hours(1)};
  LinkSender sut_{LinkRouterParams{}};
};

TEST_F(FillInRoomTest, NothingGoesBeforeTheRadiosQueueIsEmpty) {
  EXPECT_TRUE(sut_.may_fill_in(now_));
  sut_.offer(live, sample(1, 200), now_);
  EXPECT_FALSE(sut_.may_fill_in(now_)) << "a live one waits";
  ASSERT_TRUE(sut_.next(now_));
  EXPECT_FALSE(sut_.may_fill_in(now_)) << "it is in the radio";
  const Time opens = sut_.fill_in_opens(now_);
  EXPECT_GT(opens, now_);
  EXPECT_FALSE(sut_.may_fill_in(opens - Duration(1)));
  EXPECT_TRUE(sut_.may_fill_in(opens));
}

TEST_F(FillInRoomTest, OneGoesAtATime) {
  sut_.fill_in(fill_ins, sample(1, 200), now_);
  EXPECT_FALSE(sut_.may_fill_in(now_));
  EXPECT_TRUE(sut_.may_fill_in(sut_.fill_in_opens(now_)));
}

}  // namespace
}  // namespace tocsin::router
