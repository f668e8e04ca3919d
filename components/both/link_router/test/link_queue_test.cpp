// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_queue.hpp"

#include <gtest/gtest.h>

namespace tocsin::router {
namespace {

constexpr Time t0{std::chrono::hours(1)};
constexpr Duration ms = std::chrono::milliseconds(1);
constexpr std::size_t any = 1000;

Waiting waiting(StreamId stream, std::uint64_t sequence, std::size_t bytes = 100,
                SourceId source = 1) {
  Waiting one;
  one.stream = stream;
  one.sample = {{source, sequence, t0}, bytes, nullptr};
  one.cost = wire_cost(bytes);
  one.offered = t0;
  return one;
}

std::uint64_t sequence_of(const std::optional<Waiting>& one) {
  return one ? one->sample.origin.sequence : 0;
}

TEST(LinkQueue, GivesAClassInTheOrderOfItsTurns) {
  LinkQueue sut(10000);
  EXPECT_TRUE(sut.add(TrafficClass::low, 1, waiting(1, 11)).empty());
  EXPECT_TRUE(sut.add(TrafficClass::low, 1, waiting(2, 21)).empty());
  EXPECT_FALSE(sut.take_first(TrafficClass::critical, any));
  EXPECT_EQ(sequence_of(sut.take_first(TrafficClass::low, any)), 11U);
  EXPECT_EQ(sequence_of(sut.take_first(TrafficClass::low, any)), 21U);
  EXPECT_FALSE(sut.take_first(TrafficClass::low, any));
}

TEST(LinkQueue, KeepsAsManyOfASourceAsItsDepthInTheirOrder) {
  LinkQueue sut(10000);
  for (const std::uint64_t sequence : {1, 2}) {
    EXPECT_TRUE(sut.add(TrafficClass::high, 2, waiting(1, sequence)).empty());
  }
  EXPECT_TRUE(sut.add(TrafficClass::high, 2, waiting(1, 9, 100, 5)).empty()) << "another source";
  const auto dropped = sut.add(TrafficClass::high, 2, waiting(1, 3));
  ASSERT_EQ(dropped.size(), 1U);
  EXPECT_EQ(dropped[0].waiting.sample.origin.sequence, 1U);
  EXPECT_EQ(sequence_of(sut.take_first(TrafficClass::high, any)), 2U);
  EXPECT_EQ(sequence_of(sut.take_first(TrafficClass::high, any)), 3U);
  EXPECT_EQ(sequence_of(sut.take_first(TrafficClass::high, any)), 9U);
}

TEST(LinkQueue, DropsTheOldestOfAClassBeyondItsBytes) {
  LinkQueue sut(300);
  (void)sut.add(TrafficClass::low, 1, waiting(1, 11, 200));
  (void)sut.add(TrafficClass::critical, 1, waiting(9, 91, 300));
  EXPECT_TRUE(sut.add(TrafficClass::low, 1, waiting(2, 21, 100)).empty()) << "just full";
  const auto dropped = sut.add(TrafficClass::low, 1, waiting(3, 31, 101));
  ASSERT_EQ(dropped.size(), 1U);
  EXPECT_EQ(dropped[0].waiting.sample.origin.sequence, 11U);
  EXPECT_EQ(dropped[0].reason, DropReason::overflow);
  EXPECT_EQ(sut.bytes(TrafficClass::low), 201U);
  EXPECT_EQ(sut.bytes(TrafficClass::critical), 300U) << "another class is not touched";
}

TEST(LinkQueue, DoesNotDropTheNewOneThatTookTheFirstTurn) {
  LinkQueue sut(300);
  (void)sut.add(TrafficClass::low, 1, waiting(1, 11, 100));
  (void)sut.add(TrafficClass::low, 1, waiting(2, 21, 100));
  const auto dropped = sut.add(TrafficClass::low, 1, waiting(1, 12, 250));
  ASSERT_EQ(dropped.size(), 2U);
  EXPECT_EQ(dropped[1].waiting.sample.origin.sequence, 21U);
  EXPECT_EQ(sequence_of(sut.take_first(TrafficClass::low, any)), 12U);
}

TEST(LinkQueue, TakesOutWhatIsOlderThanItsLifespan) {
  LinkQueue sut(10000);
  Waiting one = waiting(1, 11);
  one.expires = t0 + 100 * ms;
  (void)sut.add(TrafficClass::high, 1, one);
  EXPECT_TRUE(sut.take_expired(t0 + 100 * ms).empty());
  EXPECT_EQ(sut.next_expiry(), t0 + 100 * ms + Duration{1});
  const auto dropped = sut.take_expired(t0 + 100 * ms + Duration{1});
  ASSERT_EQ(dropped.size(), 1U);
  EXPECT_EQ(dropped[0].reason, DropReason::expired);
  EXPECT_EQ(sut.next_expiry(), never);
}

TEST(LinkQueue, PassesBulkByWhenOnlySmallSamplesMayGo) {
  LinkQueue sut(1000000);
  (void)sut.add(TrafficClass::low, 1, waiting(1, 11, 40000));
  (void)sut.add(TrafficClass::low, 1, waiting(2, 21, 100));
  EXPECT_FALSE(sut.take_first(TrafficClass::low, 1));
  EXPECT_EQ(sequence_of(sut.take_first(TrafficClass::low, 4)), 21U);
  EXPECT_FALSE(sut.take_first(TrafficClass::low, 4));
  EXPECT_EQ(sequence_of(sut.take_first(TrafficClass::low, any)), 11U);
}

TEST(LinkQueue, LetsNoSampleOvertakeAnOlderOneOfItsSource) {
  LinkQueue sut(1000000);
  (void)sut.add(TrafficClass::low, 2, waiting(1, 11, 40000));
  (void)sut.add(TrafficClass::low, 2, waiting(1, 12, 100));
  EXPECT_FALSE(sut.take_first(TrafficClass::low, 4));
  EXPECT_EQ(sequence_of(sut.take_first(TrafficClass::low, any)), 11U);
  EXPECT_EQ(sequence_of(sut.take_first(TrafficClass::low, 4)), 12U);
}

}  // namespace
}  // namespace tocsin::router
