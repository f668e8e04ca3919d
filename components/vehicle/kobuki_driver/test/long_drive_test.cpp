// SPDX-License-Identifier: Apache-2.0
/// Driver and base in virtual time: a square, and an hour of random faults. Prints what it
/// measures.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "geometry/pose.hpp"
#include "model_rig.hpp"

namespace tocsin::kobuki {
namespace {

double distance_m(const geometry::Pose& a, const geometry::Pose& b) {
  return distance(position(a), position(b));
}

double angle_deg(const geometry::Pose& a, const geometry::Pose& b) {
  return std::abs(geometry::wrap_angle(a.heading_rad - b.heading_rad)) / degree;
}

/// Turns by odometry until the heading is reached.
void turn_to(ModelRig& rig, double heading_rad) {
  const auto left = [&] { return geometry::wrap_angle(heading_rad - rig.last.pose.heading_rad); };
  while (std::abs(left()) > 0.02) rig.run(0.05, geometry::Twist{0, std::clamp(left(), -0.6, 0.6)});
  rig.run(0.7);
}

void drive_forward(ModelRig& rig, double length_m) {
  const geometry::Pose from = rig.last.pose;
  while (distance_m(from, rig.last.pose) < length_m - 0.05) rig.run(0.05, geometry::Twist{0.3, 0});
  rig.run(0.7);
}

TEST(LongDrive, DrivesASquareOfTwoMetres) {
  ModelRig rig({}, ModelParams{});
  rig.run(0.5);
  for (int side = 0; side < 4; ++side) {
    drive_forward(rig, 2.0);
    turn_to(rig, (side + 1) * pi / 2);
  }
  const double error_m = distance_m(rig.last.pose, rig.model.pose());
  std::printf("square: odometry is off by %.3f m and %.2f deg after 8 m\n", error_m,
              angle_deg(rig.last.pose, rig.model.pose()));
  EXPECT_LT(error_m, 0.05);
  EXPECT_LT(distance_m(rig.model.pose(), geometry::Pose{}), 0.6);
  EXPECT_EQ(rig.driver.state(), BaseState::online);
}

/// One random fault of the line or the cable, for some seconds.
void strike(ModelRig& rig, std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  LineParams faulty;
  faulty.usb_latency_ms = 1 + static_cast<int>(random() % 16);
  faulty.usb_packet_bytes = 1 + static_cast<int>(random() % 62);
  const auto kind = random() % 5;
  if (kind == 0) faulty.flip_probability = uniform(0, 0.01);
  if (kind == 1) faulty.loss_probability = uniform(0, 0.01);
  if (kind == 2) faulty.noise_probability = uniform(0, 0.05);
  rig.line.configure(faulty);
  rig.silent = kind == 3;
  rig.connected = kind != 4;
  if (kind == 4) rig.driver.on_port_lost();
  const geometry::Twist wanted{uniform(-0.2, 0.4), uniform(-0.8, 0.8)};
  rig.run(uniform(0.05, 2.5), wanted);
  if (kind == 4) rig.driver.on_port_open();
  rig.silent = false;
  rig.connected = true;
  rig.line.configure(LineParams{});
}

TEST(LongDrive, SurvivesAnHourOfFaults) {
  ModelParams base;
  base.command_timeout_s = 0.5;
  ModelRig rig({}, base);
  std::mt19937 random(7);
  const Time end = rig.now + seconds(3600);
  int faults = 0;
  while (rig.now < end) {
    const double w_rad_s = std::uniform_real_distribution<double>(-0.8, 0.8)(random);
    rig.run(5, geometry::Twist{0.3, w_rad_s});
    ASSERT_EQ(rig.driver.state(), BaseState::online) << "after fault " << faults;
    strike(rig, random);
    ++faults;
  }
  rig.run(2);
  const double error_m = distance_m(rig.last.pose, rig.model.pose());
  const double error_deg = angle_deg(rig.last.pose, rig.model.pose());
  std::printf(
      "an hour with %d faults: %d readings, %llu frames rejected, odometry off by %.2f m, %.2f "
      "deg\n",
      faults, rig.readings, static_cast<unsigned long long>(rig.driver.frame_counts().rejected),
      error_m, error_deg);
  EXPECT_EQ(rig.model.velocity().linear_mps, 0);
  // Some damaged frames pass the checksum; odometry leaves them out.
  EXPECT_GT(rig.driver.odometry().rejected_jumps(), 0U);
  EXPECT_LT(error_m, 0.5);
  EXPECT_LT(error_deg, 2);
}

}  // namespace
}  // namespace tocsin::kobuki
