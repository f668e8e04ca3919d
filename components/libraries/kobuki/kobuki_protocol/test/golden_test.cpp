// SPDX-License-Identifier: Apache-2.0
/// Rows of the reference driver and frames of real bases; skipped where the files are absent.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "frames.hpp"
#include "kobuki_protocol/battery.hpp"
#include "kobuki_protocol/command.hpp"
#include "kobuki_protocol/odometry.hpp"
#include "kobuki_protocol/reassembler.hpp"
#include "kobuki_protocol/velocity.hpp"

namespace tocsin::kobuki {
namespace {

std::vector<std::string> lines_of(const std::string& file) {
  const char* shared = std::getenv("TOCSIN_SHARED");
  const std::string root =
      shared != nullptr ? shared : std::string(TOCSIN_REPOSITORY) + "/../shared";
  std::ifstream in(root + "/data/kobuki/" + file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line[0] != '#') lines.push_back(line);
  }
  return lines;
}

std::string after_colon(const std::string& line) { return line.substr(line.rfind(':') + 1); }

/// Speed before rounding (reference page 1.5).
double exact_speed(double v, double w, int radius) {
  const double outer = 115 * std::abs(w);
  if (radius == 0) return 1000 * v;
  if (radius == 1 && std::abs(1000 * v) <= std::abs(1.5 * w)) return 115 * w;
  return 1000 * v + std::copysign(outer, v);
}

TEST(Golden, VelocityIsEqualOrBetterByRounding) {
  const auto lines = lines_of("velocity_commands.txt");
  if (lines.empty()) GTEST_SKIP() << "no data/kobuki";
  for (const std::string& line : lines) {
    double v = 0;
    double w = 0;
    int speed = 0;
    int radius = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "VEL %lf %lf -> %d %d", &v, &w, &speed, &radius), 4);
    const BaseControl got = encode_velocity({v, w});
    if (radius == -1) {
      EXPECT_EQ(got.radius_mm, 1) << line;
      continue;
    }
    EXPECT_LE(std::abs(got.speed_mm_s - speed), 1) << line;
    EXPECT_LE(std::abs(got.radius_mm - radius), 1) << line;
    const double exact = std::min(exact_speed(v, w, got.radius_mm), 32767.0);
    EXPECT_NEAR(got.speed_mm_s, exact, 0.5 + 1e-9) << line;
    if (got.speed_mm_s != speed || got.radius_mm != radius) continue;
    EXPECT_EQ(to_bytes(encode_command(got).bytes()), from_hex(after_colon(line))) << line;
  }
}

TEST(Golden, BatteryIsEqualWhereTheReferenceIsSound) {
  const auto lines = lines_of("battery_states.txt");
  if (lines.empty()) GTEST_SKIP() << "no data/kobuki";
  const BatteryReader sut{BatteryParams{}};
  for (const std::string& line : lines) {
    int raw = 0;
    int charger = 0;
    const int read = std::sscanf(line.c_str(), "BAT raw=%d charger=%d", &raw, &charger);
    if (read != 2 || charger % 16 == 2) continue;  // its "charged" is faulty
    int state = 0;
    int source = 0;
    int level = 0;
    double percent = 0;
    const std::string rest = line.substr(line.find("state="));
    ASSERT_EQ(std::sscanf(rest.c_str(), "state=%d src=%d level=%d pct=%lf", &state, &source, &level,
                          &percent),
              4);
    const Battery got =
        sut.read(static_cast<std::uint8_t>(raw), static_cast<std::uint8_t>(charger));
    EXPECT_NEAR(100 * got.percentage, percent, 1e-4) << line;
    EXPECT_EQ(static_cast<int>(got.level), level) << line;
    EXPECT_EQ(static_cast<int>(got.state), state) << line;
    EXPECT_EQ(static_cast<int>(got.source), source) << line;
  }
}

void expect_wheels(const Odometry& sut, const std::string& line) {
  double left = 0;
  double left_rate = 0;
  double right = 0;
  double right_rate = 0;
  const std::string wheel = line.substr(line.find("wheel="));
  ASSERT_EQ(
      std::sscanf(wheel.c_str(), "wheel=%lf,%lf,%lf,%lf", &left, &left_rate, &right, &right_rate),
      4);
  EXPECT_NEAR(sut.left().angle_rad, left, 1e-6) << line;
  EXPECT_NEAR(sut.left().rate_rad_s, left_rate, 2e-6) << line;
  EXPECT_NEAR(sut.right().angle_rad, right, 1e-6) << line;
  EXPECT_NEAR(sut.right().rate_rad_s, right_rate, 2e-6) << line;
}

TEST(Golden, OdometryIsEqual) {
  const auto lines = lines_of("commands_and_odometry.txt");
  if (lines.empty()) GTEST_SKIP() << "no data/kobuki";
  OdometryParams params;
  params.use_gyro_heading = false;
  Odometry sut{params};
  int fed = 0;
  for (const std::string& line : lines) {
    int row = 0;
    if (std::sscanf(line.c_str(), "ODO %d", &row) != 1) continue;
    for (; fed <= row; ++fed) {
      CoreSensors core;
      core.timestamp_ms = static_cast<std::uint16_t>(65000 + 20 * fed);
      core.left_encoder = static_cast<std::uint16_t>(65500 + 40 * fed);
      core.right_encoder = static_cast<std::uint16_t>(65400 + 60 * fed);
      sut.update(core, {});
    }
    double x = 0;
    double y = 0;
    double heading = 0;
    const std::string pose = line.substr(line.find("pose="));
    ASSERT_EQ(std::sscanf(pose.c_str(), "pose=%lf,%lf,%lf", &x, &y, &heading), 3);
    EXPECT_NEAR(sut.pose().x_m, x, 1e-7) << line;
    EXPECT_NEAR(sut.pose().y_m, y, 1e-7) << line;
    EXPECT_NEAR(sut.pose().heading_rad, heading, 1e-7) << line;
    expect_wheels(sut, line);
  }
  EXPECT_EQ(fed, 55);
}

TEST(Golden, CommandsDecodeToTheSameBytes) {
  const auto lines = lines_of("commands_and_odometry.txt");
  if (lines.empty()) GTEST_SKIP() << "no data/kobuki";
  int seen = 0;
  for (const std::string& line : lines) {
    if (line.rfind("ODO", 0) == 0) continue;
    const Bytes bytes = from_hex(after_colon(line));
    Reassembler reassembler;
    DecodeCounts counts;
    reassembler.feed(view(bytes), [&](ByteView payload) {
      decode_commands(payload, counts, [&](const Command& command) {
        ++seen;
        EXPECT_EQ(to_bytes(encode_command(command).bytes()), bytes) << line;
      });
    });
    EXPECT_EQ(counts.known, 1U) << line;
  }
  EXPECT_GE(seen, 20);
}

TEST(Golden, RealFramesDecodeAndEncodeToTheSameBytes) {
  const auto lines = lines_of("real_frames.txt");
  if (lines.empty()) GTEST_SKIP() << "no data/kobuki";
  std::vector<CoreSensors> cores;
  for (const std::string& line : lines) {
    const Bytes bytes = from_hex(line);
    Reassembler reassembler;
    DecodeCounts counts;
    reassembler.feed(view(bytes), [&](ByteView payload) {
      const Feedback feedback = decode_feedback(payload, counts);
      cores.push_back(*feedback.core);
      EXPECT_EQ(to_bytes(encode_feedback(feedback).bytes()), bytes);
    });
    EXPECT_EQ(counts.malformed + counts.truncated + counts.unknown, 0U);
  }
  ASSERT_EQ(cores.size(), 3U);
  EXPECT_EQ(cores[0].timestamp_ms, 61840);
  EXPECT_EQ(cores[2].timestamp_ms, 61880);
  EXPECT_EQ(cores[1].charger, 18);
  EXPECT_EQ(cores[1].battery_dv, 159);
  EXPECT_EQ(cores[1].left_encoder - cores[0].left_encoder, 7);
}

}  // namespace
}  // namespace tocsin::kobuki
