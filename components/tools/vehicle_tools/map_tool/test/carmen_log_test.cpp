// SPDX-License-Identifier: Apache-2.0
#include "carmen_log.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"

namespace tocsin::map_tool {
namespace {

std::vector<LogReading> read(const std::string& text) {
  CarmenLog log(text, "log");
  std::vector<LogReading> readings;
  while (auto reading = log.next()) readings.push_back(std::move(*reading));
  return readings;
}

std::string error_of(const std::string& text) {
  try {
    (void)read(text);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

const std::string robot_laser =
    "ROBOTLASER1 0 -1.5 3 1.5 20 0.01 0 3 1 2 20 2 7 8 1.2 2 0.6 1 2 0.5 0.1 0 0.4 0.4 1e6 12.5 "
    "host 1\n";

TEST(CarmenLog, ReadsOdometry) {
  const auto readings = read("ODOM 1.5 -2 7.0 0.3 0.1 0 12.25 host 0.5\n");
  ASSERT_EQ(readings.size(), 1U);
  EXPECT_DOUBLE_EQ(readings[0].time_s, 12.25);
  EXPECT_DOUBLE_EQ(readings[0].odometry.x_m, 1.5);
  EXPECT_DOUBLE_EQ(readings[0].odometry.y_m, -2);
  EXPECT_NEAR(readings[0].odometry.heading_rad, 7.0 - 2 * pi, 1e-12);
  EXPECT_FALSE(readings[0].scan);
}

TEST(CarmenLog, ReadsTheFrontLaserWithTheOdometryAndNotWithAPoseThatWasCorrected) {
  const auto readings = read("FLASER 3 1 2.5 81.9 9 9 9 1 2 0.5 12.25 host 0.5");
  ASSERT_EQ(readings.size(), 1U);
  EXPECT_DOUBLE_EQ(readings[0].odometry.x_m, 1);
  ASSERT_TRUE(readings[0].scan);
  EXPECT_EQ(readings[0].scan->ranges_m, (std::vector<double>{1, 2.5, 81.9}));
}

TEST(CarmenLog, BeamsOfTheFrontLaserCoverHalfATurnAsCarmenTakesIt) {
  for (const auto& [count, increment_deg] :
       std::vector<std::pair<int, double>>{{180, 1}, {181, 1}, {360, 0.5}, {361, 0.5}}) {
    std::string line = "FLASER " + std::to_string(count);
    for (int i = 0; i < count; ++i) line += " 1";
    const auto readings = read(line + " 0 0 0 0 0 0 1 host 1");
    ASSERT_EQ(readings.size(), 1U);
    EXPECT_DOUBLE_EQ(readings[0].scan->beams.first_rad, -pi / 2);
    EXPECT_NEAR(readings[0].scan->beams.increment_rad, increment_deg * degree, 1e-12) << count;
  }
}

TEST(CarmenLog, ReadsARobotLaserWithItsPlaceOnTheRobot) {
  const auto readings = read(robot_laser);
  ASSERT_EQ(readings.size(), 1U);
  const LogScan& scan = readings[0].scan.value();
  EXPECT_DOUBLE_EQ(readings[0].time_s, 12.5);
  EXPECT_DOUBLE_EQ(readings[0].odometry.heading_rad, 0.5);
  EXPECT_EQ(scan.ranges_m, (std::vector<double>{1, 2, 20}));
  EXPECT_DOUBLE_EQ(scan.beams.first_rad, -1.5);
  EXPECT_DOUBLE_EQ(scan.beams.increment_rad, 1.5);
  EXPECT_DOUBLE_EQ(scan.max_range_m, 20);
  EXPECT_NEAR(scan.beams.laser.x_m, 0.2 * std::cos(0.5), 1e-12);
  EXPECT_NEAR(scan.beams.laser.heading_rad, 0.1, 1e-12);
}

TEST(CarmenLog, PassesOverCommentsOtherMessagesAndEmptyLines) {
  EXPECT_EQ(read("# made by hand\n\nPARAM robot_length 0.5 host 0\r\nRLASER 1 1\n   \n").size(),
            0U);
}

TEST(CarmenLog, RefusesAnOdometryThatJumps) {
  const std::string first = "ODOM 0 0 0 0 0 0 1 h 1\n";
  EXPECT_EQ(read(first + "ODOM 100 0 0 0 0 0 2 h 2\n").size(), 2U);
  EXPECT_EQ(error_of(first + "ODOM 101 0 0 0 0 0 2 h 2\n"),
            "log:2: odometry: jumps by 101 m from the reading before it; 100 m are allowed");
}

TEST(CarmenLog, HasOneClearErrorForEveryBadLine) {
  const std::vector<std::pair<std::string, std::string>> table{
      {"ODOM 1 2", "log:2: pose: is missing, the line ends before it"},
      {"ODOM 1 two 3 0 0 0 1 host 1", "log:2: pose: 'two' is no number"},
      {"ODOM 1 2e9 3 0 0 0 1 host 1", "log:2: pose: 2e9 is outside [-1e+06, 1e+06]"},
      {"ODOM 1 nan 3 0 0 0 1 host 1", "log:2: pose: nan is outside [-1e+06, 1e+06]"},
      {"ODOM 1 2 3 0 0 0 -1 host 1", "log:2: time: -1 is outside [0, 1e+12]"},
      {"FLASER 1 1 0 0 0 0 0 0 1 h 1", "log:2: number of readings: 1 is outside [2, 100000]"},
      {"FLASER 2.5 1 0 0 0 0 0 0 1 h 1", "log:2: number of readings: 2.5 is no whole number"},
      {"FLASER 2 1 -0.5 0 0 0 0 0 0 1 h 1", "log:2: range: -0.5 is outside [0, 1e+06]"},
      {"FLASER 3 1 2", "log:2: range: is missing, the line ends before it"},
      {"ROBOTLASER1 0 -1.5 3 0 20", "log:2: angular resolution: 0 is outside [0.0001, 3.14159]"},
      {"odom 1 2 3",
       "log:2: 'odom' is no message of CARMEN: those are capital letters (ODOM, "
       "FLASER, ROBOTLASER1, others are passed over)"},
  };
  for (const auto& [line, error] : table) EXPECT_EQ(error_of("# first\n" + line + "\n"), error);
}

}  // namespace
}  // namespace tocsin::map_tool
