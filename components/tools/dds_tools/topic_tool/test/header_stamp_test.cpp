// SPDX-License-Identifier: Apache-2.0
#include "header_stamp.hpp"

#include <gtest/gtest.h>

#include "ros_idl/nav_msgs.hpp"
#include "ros_idl/std_msgs.hpp"

namespace tocsin::topic_tool {
namespace {

TEST(HeaderStamp, IsThatOfTheMessageNotOfWhatItHolds) {
  nav_msgs::msg::Path path;
  path.header().stamp().sec(3);
  path.header().stamp().nanosec(7);
  path.poses().resize(1);
  path.poses()[0].header().stamp().sec(99);
  EXPECT_EQ(header_stamp_ns(type_info<nav_msgs::msg::Path>(), &path), 3'000'000'007);
}

TEST(HeaderStamp, MayLieBeforeTheEpoch) {
  nav_msgs::msg::Path path;
  path.header().stamp().sec(-1);
  path.header().stamp().nanosec(5);
  EXPECT_EQ(header_stamp_ns(type_info<nav_msgs::msg::Path>(), &path), -999'999'995);
}

TEST(HeaderStamp, IsMissingWhereTheTypeHasNone) {
  const std_msgs::msg::String text;
  EXPECT_EQ(header_stamp_ns(type_info<std_msgs::msg::String>(), &text), std::nullopt);
}

}  // namespace
}  // namespace tocsin::topic_tool
