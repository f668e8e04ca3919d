// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/dock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "kobuki_model/base_model.hpp"

namespace tocsin::kobuki {
namespace {

const Dock sut{{0, 0, 0}};  // at the origin, facing +x

/// What the middle receiver sees when it is at a place and the base faces the dock.
int seen_at(double x_m, double y_m) {
  const double facing_rad = std::atan2(-y_m, -x_m);
  const geometry::Pose base{x_m - DockLight{}.rim_m * std::cos(facing_rad),
                            y_m - DockLight{}.rim_m * std::sin(facing_rad), facing_rad};
  return sut.infrared(base).centre;
}

constexpr int near_all = 1 | 2 | 4;
constexpr int far_all = 8 | 16 | 32;

TEST(Dock, ShinesNearAndFarInThreeBeams) {
  struct {
    double x_m, y_m;
    int seen;
  } const places[] = {{2.39, 0, near_all | far_all},
                      {2.41, 0, far_all},
                      {4.99, 0, far_all},
                      {5.01, 0, 0},
                      {-1, 0, 0},
                      // its own left and right
                      {3, 0.5, 16},
                      {3, -0.5, 32},
                      {1, 0.5, 16 | 1},
                      {1, -0.5, 32 | 4},
                      // side beams overlap at the centre line
                      {3, 0.029, 8 | 16 | 32},
                      {3, 0.031, 8 | 16},
                      {3, -0.031, 8 | 32},
                      // the centre beam is as wide everywhere
                      {3, 0.054, 8 | 16},
                      {3, 0.056, 16},
                      {0.5, 0.056, 16 | 1}};
  for (const auto& [x_m, y_m, seen] : places)
    EXPECT_EQ(seen_at(x_m, y_m), seen) << x_m << ' ' << y_m;
  for (const auto& [angle_deg, seen] : {std::pair(54.9, 16 | 1), {55.1, 0}, {-55.1, 0}}) {
    EXPECT_EQ(seen_at(std::cos(angle_deg * degree), std::sin(angle_deg * degree)), seen);
  }
}

TEST(Dock, IsSeenByTheReceiverThatFacesIt) {
  EXPECT_EQ(sut.infrared({3, 0, pi}).left, 0);
  const DockInfrared turned_left = sut.infrared({3, 0, pi + 80 * degree});
  EXPECT_NE(turned_left.right, 0);
  EXPECT_EQ(turned_left.centre, 0);
  EXPECT_NE(sut.infrared({3, 0, pi - 80 * degree}).left, 0);
  EXPECT_EQ(sut.infrared({3, 0, 0}).centre, 0);
}

// A base askew on the centre line has its receivers beside it. The reference's docking steers by
// that: with receivers in the middle of the base it docks from 28 of 300 starts, so from 285.
TEST(Dock, IsSeenFromTheRimOfTheBase) {
  EXPECT_EQ(sut.infrared({2, 0, pi}).centre, near_all | far_all);
  EXPECT_EQ(sut.infrared({2, 0, pi + 25 * degree}).centre, 32 | 4);
  EXPECT_EQ(sut.infrared({2, 0, pi - 25 * degree}).centre, 16 | 1);
}

TEST(Dock, ChargesOnlyInFrontInTheMiddleAndFacing) {
  const double x = body_radius_m + 0.01;
  for (const auto& [pose, charges] : {std::pair(geometry::Pose{x, 0, pi}, true),
                                      {{x, 0.049, pi}, true},
                                      {{x, 0.051, pi}, false},
                                      {{x + 0.003, 0, pi}, false},
                                      {{x, 0, pi + 24 * degree}, true},
                                      {{x, 0, pi + 26 * degree}, false}}) {
    EXPECT_EQ(sut.in_contact(pose), charges)
        << pose.x_m << ' ' << pose.y_m << ' ' << pose.heading_rad;
  }
}

TEST(Dock, StopsAndChargesABase) {
  const Time t0 = Time{} + seconds(1);
  BaseModel model(ModelParams{}, walled({sut.front()}), {1, 0, pi}, 1, t0);
  model.set_dock(sut);
  for (int i = 1; i < 500; ++i) {
    const Time now = t0 + i * std::chrono::milliseconds(20);
    model.receive(encode_command(BaseControl{100, 0}).bytes(), now);
    model.step(now, [](Time, ByteView) {});
  }
  EXPECT_EQ(model.power().source(), ChargingSource::dock);
  model.place({1, 0, pi});
  model.step(t0 + seconds(11), [](Time, ByteView) {});
  EXPECT_EQ(model.power().source(), ChargingSource::none);
}

}  // namespace
}  // namespace tocsin::kobuki
