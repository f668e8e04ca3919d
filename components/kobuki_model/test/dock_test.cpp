// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/dock.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kobuki_model/base_model.hpp"

namespace tocsin::kobuki {
namespace {

const Dock sut{{0, 0, 0}};  // at the origin, facing +x

TEST(Dock, ShinesNearAndFarAhead) {
  EXPECT_EQ(sut.infrared({0.7, 0, pi}).centre, 2);
  EXPECT_EQ(sut.infrared({0.71, 0, pi}).centre, 8);
  EXPECT_EQ(sut.infrared({3.0, 0, pi}).centre, 8);
  EXPECT_EQ(sut.infrared({3.01, 0, pi}).centre, 0);
  EXPECT_EQ(sut.infrared({-1, 0, 0}).centre, 0);
}

TEST(Dock, HasItsOwnLeftAndRight) {
  EXPECT_EQ(sut.infrared({1, 0.5, pi}).centre, 16);
  EXPECT_EQ(sut.infrared({1, -0.5, pi}).centre, 32);
  EXPECT_EQ(sut.infrared({0.4, 0.2, pi}).centre, 1);
  EXPECT_EQ(sut.infrared({0.4, -0.2, pi}).centre, 4);
}

TEST(Dock, HasBeamsThatOverlap) {
  const auto seen_at = [](double angle_deg) {
    const double angle = angle_deg * degree_rad;
    return int{sut.infrared({std::cos(angle), std::sin(angle), angle + pi}).centre};
  };
  EXPECT_EQ(seen_at(3.9), 8);
  EXPECT_EQ(seen_at(4.1), 8 | 16);
  EXPECT_EQ(seen_at(-9.9), 8 | 32);
  EXPECT_EQ(seen_at(-10.1), 32);
  EXPECT_EQ(seen_at(55.1), 0);
}

TEST(Dock, IsSeenByTheReceiverThatFacesIt) {
  EXPECT_EQ(sut.infrared({1, 0, pi}).left, 0);
  const DockInfrared turned_left = sut.infrared({1, 0, pi + 80 * degree_rad});
  EXPECT_EQ(turned_left.right, 8);
  EXPECT_EQ(turned_left.centre, 0);
  EXPECT_EQ(sut.infrared({1, 0, pi - 80 * degree_rad}).left, 8);
  EXPECT_EQ(sut.infrared({1, 0, 0}).centre, 0);
}

TEST(Dock, ChargesOnlyInFrontInTheMiddleAndFacing) {
  const double x = body_radius_m + 0.01;
  EXPECT_TRUE(sut.in_contact({x, 0, pi}));
  EXPECT_TRUE(sut.in_contact({x, 0.049, pi}));
  EXPECT_FALSE(sut.in_contact({x, 0.051, pi}));
  EXPECT_FALSE(sut.in_contact({x + 0.003, 0, pi}));
  EXPECT_TRUE(sut.in_contact({x, 0, pi + 24 * degree_rad}));
  EXPECT_FALSE(sut.in_contact({x, 0, pi + 26 * degree_rad}));
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
