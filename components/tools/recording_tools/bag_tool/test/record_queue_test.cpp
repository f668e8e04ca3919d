// SPDX-License-Identifier: Apache-2.0
#include "record_queue.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace tocsin::bag_tool {
namespace {

constexpr Duration no_wait{0};
constexpr Duration long_wait = std::chrono::seconds(20);

RawSample sample_of(std::size_t bytes, std::uint64_t sequence = 0) {
  RawSample sample;
  sample.bytes = std::make_shared<std::vector<std::uint8_t>>(bytes);
  sample.sequence = sequence;
  return sample;
}

TEST(RecordQueue, GivesAllInTheOrderOfArrival) {
  RecordQueue sut(1000);
  for (std::uint64_t i = 0; i < 5; ++i) sut.push(i % 2, sample_of(10, i));
  const auto items = sut.take(no_wait);
  ASSERT_EQ(items.size(), 5U);
  for (std::uint64_t i = 0; i < 5; ++i) {
    EXPECT_EQ(items[i].sample.sequence, i);
    EXPECT_EQ(items[i].topic, i % 2);
  }
  EXPECT_TRUE(sut.take(no_wait).empty());
}

TEST(RecordQueue, DropsAndCountsWhatHasNoRoom) {
  RecordQueue sut(100);
  sut.push(0, sample_of(60));
  sut.push(0, sample_of(40));
  sut.push(0, sample_of(1));
  EXPECT_EQ(sut.dropped(), 1U);
  EXPECT_EQ(sut.take(no_wait).size(), 2U);
  sut.push(0, sample_of(100));
  EXPECT_EQ(sut.dropped(), 1U) << "there is room again";
}

TEST(RecordQueue, TakesOneSampleThatIsLargerThanItsRoom) {
  RecordQueue sut(100);
  sut.push(0, sample_of(1000));
  EXPECT_EQ(sut.dropped(), 0U);
  EXPECT_EQ(sut.take(no_wait).size(), 1U);
}

TEST(RecordQueue, WakesWhoWaits) {
  RecordQueue sut(100);
  std::thread other([&] { sut.push(7, sample_of(1)); });
  const auto items = sut.take(long_wait);
  other.join();
  ASSERT_EQ(items.size(), 1U);
  EXPECT_EQ(items[0].topic, 7U);
}

}  // namespace
}  // namespace tocsin::bag_tool
