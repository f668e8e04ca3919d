// SPDX-License-Identifier: Apache-2.0
#include "laser_geometry/scan_message.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "ros_idl/sensor_msgs.hpp"

namespace tocsin::laser {
namespace {

using Message = sensor_msgs::msg::LaserScan;

/// Two beams, ahead and to the left.
Message two_beams(float ahead_m, float left_m) {
  Message message;
  message.angle_increment(static_cast<float>(pi / 2));
  message.range_min(0.15F);
  message.range_max(12);
  message.ranges({ahead_m, left_m});
  return message;
}

TEST(ScanMessage, BecomesPointsOfTheVehicle) {
  const auto scan = scan_of(two_beams(2, 3), {0.1, 0, pi / 2}, {});
  ASSERT_TRUE(scan);
  ASSERT_EQ(scan->hits.size(), 2U);
  EXPECT_NEAR(scan->hits[0].x_m, 0.1, 1e-6);
  EXPECT_NEAR(scan->hits[0].y_m, 2, 1e-6);
  EXPECT_NEAR(scan->hits[1].x_m, 0.1 - 3, 1e-6);
}

TEST(ScanMessage, TakesWhatIsFarForNoReturn) {
  const auto scan = scan_of(two_beams(12, std::numeric_limits<float>::infinity()), {}, {});
  ASSERT_TRUE(scan);
  EXPECT_TRUE(scan->hits.empty());
  EXPECT_EQ(scan->misses.size(), 2U);
  EXPECT_TRUE(scan_of(two_beams(0.1F, 0.14F), {}, {})->hits.empty()) << "below range_min";
}

TEST(ScanMessage, RefusesWhatIsNoScan) {
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  const std::vector<std::pair<const char*, std::function<void(Message&)>>> damages{
      {"no readings", [](Message& m) { m.ranges({}); }},
      {"first angle", [](Message& m) { m.angle_min(none); }},
      {"increment", [](Message& m) { m.angle_increment(none); }},
      {"more than a turn", [](Message& m) { m.angle_increment(7); }},
      {"a beam takes a second", [](Message& m) { m.time_increment(-1); }},
      {"time is none", [](Message& m) { m.time_increment(none); }},
      {"no range", [](Message& m) { m.range_max(0.15F); }},
      {"negative range", [](Message& m) { m.range_min(-1); }},
      {"ranges are none", [](Message& m) { m.range_min(none); }}};
  for (const auto& [what, damage] : damages) {
    Message message = two_beams(2, 3);
    damage(message);
    EXPECT_FALSE(scan_of(message, {}, {})) << what;
  }
}

}  // namespace
}  // namespace tocsin::laser
