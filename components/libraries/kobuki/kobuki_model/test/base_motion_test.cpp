// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/pose.hpp"
#include "kobuki_model/base_model.hpp"

namespace tocsin::kobuki {
namespace {

const Time t0 = Time{} + seconds(100);

ModelParams exact() {
  ModelParams params;
  params.slip_sigma = 0;
  params.gyro_drift_deg_per_sqrt_s = 0;
  params.gyro_noise_dps = 0;
  return params;
}

TEST(BaseModel, MovesTheSameHoweverItsCallerCutsTheTime) {
  const auto drive = [](Duration cut) {
    ModelParams params = exact();
    params.command_delay_s = 0.1;
    BaseModel model(params, walled({{2, -5, 2, 5, 0}}), {}, 1, t0);
    model.receive(encode_command(BaseControl{500, 4000}).bytes(), t0);
    for (Time now = t0; now < t0 + seconds(3); now += cut) model.step(now, [](Time, ByteView) {});
    model.receive(encode_command(BaseControl{200, 1}).bytes(), t0 + seconds(3.01));
    model.step(t0 + seconds(6), [](Time, ByteView) {});
    return model.pose();
  };
  const geometry::Pose expected = drive(std::chrono::milliseconds(20));
  for (const Duration cut : {Duration(std::chrono::milliseconds(1)), Duration(7'000'001)}) {
    EXPECT_NEAR(drive(cut).x_m, expected.x_m, 1e-3);
    EXPECT_NEAR(drive(cut).y_m, expected.y_m, 1e-3);
    EXPECT_NEAR(geometry::wrap_angle(drive(cut).heading_rad - expected.heading_rad), 0, 1e-3);
  }
}

TEST(BaseModel, BeginsToMoveExactlyAfterTheDeadTime) {
  ModelParams params = exact();
  params.command_delay_s = 0.1;
  BaseModel sut(params, open_floor(), {}, 1, t0);
  sut.step(t0 + std::chrono::milliseconds(3), [](Time, ByteView) {});
  sut.receive(encode_command(BaseControl{500, 0}).bytes(), t0 + std::chrono::milliseconds(3));
  sut.step(t0 + std::chrono::milliseconds(103), [](Time, ByteView) {});
  EXPECT_EQ(sut.pose().x_m, 0);
  sut.step(t0 + std::chrono::milliseconds(113), [](Time, ByteView) {});
  EXPECT_NEAR(sut.pose().x_m, 0.5 * 1.5 * 0.01 * 0.01, 1e-12);
  EXPECT_NEAR(sut.velocity().linear_mps, 0.015, 1e-12);
}

TEST(BaseModel, OnSlipperyFloorItsWheelsTurnFartherThanItMoves) {
  const auto drive = [](double slip) {
    BaseModel model(exact(), open_floor(), {}, 1, t0);
    model.inputs().slip = slip;
    model.receive(encode_command(BaseControl{300, 0}).bytes(), t0);
    model.step(t0 + seconds(0.5), [](Time, ByteView) {});
    return model;
  };
  EXPECT_NEAR(drive(0.25).pose().x_m, 0.75 * drive(0).pose().x_m, 1e-6);
  EXPECT_EQ(drive(1).pose().x_m, 0);
  EXPECT_EQ(drive(1).memory(t0).left_ticks, drive(0).memory(t0).left_ticks);
}

TEST(BaseModel, DriftsAsARandomWalkWithTheDeviationOfItsParameter) {
  ModelParams params = exact();
  params.gyro_drift_deg_per_sqrt_s = 1;
  double squares = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    BaseModel sut(params, open_floor(), {}, seed, t0);
    sut.step(t0 + seconds(4), [](Time, ByteView) {});
    squares += std::pow(sut.memory(t0).gyro_rad / degree, 2);
  }
  EXPECT_NEAR(std::sqrt(squares / 300), 2, 0.25);  // 3 deviations of the estimate
}

}  // namespace
}  // namespace tocsin::kobuki
