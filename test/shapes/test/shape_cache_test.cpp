// SPDX-License-Identifier: Apache-2.0
#include "shapes/shape_cache.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin::shapes {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const Time t0{std::chrono::hours(1)};
constexpr Duration for_ever = Duration::max();

Sample sample(std::uint64_t instance, std::uint64_t number, Time received = t0) {
  Sample one;
  one.instance = instance;
  one.sequence = number;
  one.received = received;
  return one;
}

QosProfile keeping(int depth) {
  QosProfile qos;
  if (depth == 0) qos.history = History::keep_all;
  if (depth > 0) qos.depth = depth;
  return qos;
}

std::vector<std::uint64_t> numbers(const std::vector<Sample>& samples) {
  std::vector<std::uint64_t> all;
  for (const Sample& one : samples) all.push_back(one.sequence);
  return all;
}

TEST(ShapeCache, KeepsTheLastOfEachInstance) {
  ShapeCache sut(keeping(2));
  for (int i = 1; i <= 3; ++i) {
    sut.add(sample(7, static_cast<std::uint64_t>(i)), for_ever);
    sut.add(sample(8, static_cast<std::uint64_t>(10 + i)), for_ever);
  }
  EXPECT_THAT(numbers(sut.take(t0)), ElementsAre(2, 3, 12, 13));
  EXPECT_THAT(sut.take(t0), IsEmpty());
}

TEST(ShapeCache, DropsWhatHasOutlivedItsLifespan) {
  ShapeCache sut(keeping(0));
  sut.add(sample(7, 1, t0), std::chrono::milliseconds(250));
  sut.add(sample(7, 2, t0 + std::chrono::milliseconds(100)), std::chrono::milliseconds(250));
  EXPECT_THAT(numbers(sut.read(t0 + std::chrono::milliseconds(249))), ElementsAre(1, 2));
  EXPECT_THAT(numbers(sut.read(t0 + std::chrono::milliseconds(250))), ElementsAre(2));
  EXPECT_THAT(numbers(sut.take(t0 + std::chrono::milliseconds(350))), IsEmpty());
}

}  // namespace
}  // namespace tocsin::shapes
