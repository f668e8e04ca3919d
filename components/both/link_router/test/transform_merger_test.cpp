// SPDX-License-Identifier: Apache-2.0
#include "transform_merger.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tocsin {
namespace {

constexpr Time t0{std::chrono::hours(1)};
constexpr Duration interval = std::chrono::milliseconds(50);

TransformMerger::Message transform(const std::string& child, std::int32_t second, double x,
                                   const std::string& parent = "odom") {
  TransformMerger::Message message;
  auto& one = message.transforms().emplace_back();
  one.header().frame_id(parent);
  one.header().stamp().sec(second);
  one.child_frame_id(child);
  one.transform().translation().x(x);
  return message;
}

TEST(TransformMerger, TheFirstGoesAtOnceAndTheNextAfterAnInterval) {
  TransformMerger sut(interval);
  EXPECT_EQ(sut.deadline(), never);
  sut.add(transform("base", 1, 0.1), 7);
  const auto first = sut.take(t0);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->message.transforms().size(), 1U);
  EXPECT_EQ(first->sent_wall_ns, 7);
  sut.add(transform("base", 2, 0.2), 8);
  EXPECT_FALSE(sut.take(t0 + interval - Duration{1}));
  EXPECT_EQ(sut.deadline(), t0 + interval);
  EXPECT_TRUE(sut.take(t0 + interval));
  EXPECT_FALSE(sut.take(t0 + 2 * interval)) << "nothing new";
}

TEST(TransformMerger, EachMessageHasTheNewestOfEveryFrameThatCame) {
  TransformMerger sut(interval);
  sut.add(transform("base", 1, 0.1), 1);
  sut.add(transform("arm", 1, 5, "base"), 2);
  sut.add(transform("base", 3, 0.3), 4);
  sut.add(transform("base", 2, 0.2), 3);
  const auto merged = sut.take(t0);
  ASSERT_TRUE(merged);
  const auto& all = merged->message.transforms();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].child_frame_id(), "arm");
  EXPECT_EQ(all[0].header().frame_id(), "base");
  EXPECT_EQ(all[1].transform().translation().x(), 0.3) << "whatever came last";
  EXPECT_EQ(merged->sent_wall_ns, 4);
}

TEST(TransformMerger, AFrameMayChangeItsParent) {
  TransformMerger sut(interval);
  sut.add(transform("cup", 1, 0.1, "table"), 1);
  sut.add(transform("cup", 2, 0.2, "hand"), 2);
  const auto merged = sut.take(t0);
  ASSERT_EQ(merged->message.transforms().size(), 1U);
  EXPECT_EQ(merged->message.transforms()[0].header().frame_id(), "hand");
}

TEST(TransformMerger, OfVeryManyFramesSomeAreLeftOut) {
  TransformMerger sut(interval);
  for (std::size_t i = 0; i < 2 * TransformMerger::most_frames; ++i) {
    sut.add(transform("frame" + std::to_string(i), 1, 0), 1);
  }
  EXPECT_EQ(sut.take(t0)->message.transforms().size(), TransformMerger::most_frames);
}

}  // namespace
}  // namespace tocsin
