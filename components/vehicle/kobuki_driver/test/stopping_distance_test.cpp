// SPDX-License-Identifier: Apache-2.0
/// How far the base rolls after the death of each process on the way of a velocity, in the
/// simulated base (dead time 0.1 s, 1.5 m/s2). Printed, and bounded.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "model_rig.hpp"

namespace tocsin::kobuki {
namespace {

struct Stop {
  double time_s = 0;
  double way_m = 0;
};

ModelParams base_with_timeout() {
  ModelParams base;
  base.command_timeout_s = 0.5;  // config/base.yaml; whether a real base has one is unknown
  return base;
}

/// Drives at `speed`, lets `die` happen, and measures until the base stands.
template <class Death>
Stop stop_after(ModelRig& rig, double speed_mps, const Death& die) {
  rig.run(2, geometry::Twist{speed_mps, 0});
  const double x_m = rig.model.pose().x_m;
  const Time died = rig.now;
  die(rig);
  while (rig.model.velocity().linear_mps > 0 && rig.now < died + seconds(5)) rig.run(0.005);
  return {to_seconds(rig.now - died), rig.model.pose().x_m - x_m};
}

void print(const char* who, double speed_mps, const Stop& stop) {
  std::printf("%-34s at %.1f m/s: stands after %.2f s and %.3f m\n", who, speed_mps, stop.time_s,
              stop.way_m);
}

class StoppingDistance : public ::testing::TestWithParam<double> {
 protected:
  /// Coasting at full speed for `delay`, then braking.
  void expect_bound(const Stop& stop, double delay_s) {
    const double brake_s = GetParam() / 1.5;
    EXPECT_LT(stop.time_s, delay_s + brake_s);
    EXPECT_LT(stop.way_m, GetParam() * (delay_s + brake_s / 2) + 0.01);
    EXPECT_GT(stop.way_m, 0.01);
  }
};

// Nothing comes any more: only the base's own timeout stops it.
TEST_P(StoppingDistance, AfterDriverDeathIsBoundedByTheTimeoutOfTheBase) {
  ModelRig rig({}, base_with_timeout());
  const Stop stop = stop_after(rig, GetParam(), [](ModelRig& r) { r.connected = false; });
  print("driver killed, or cable pulled", GetParam(), stop);
  expect_bound(stop, 0.5 + 0.02 + 0.1);
}

TEST_P(StoppingDistance, AfterTheDriverWasEndedIsThatOfTheBrakes) {
  ModelRig rig({}, base_with_timeout());
  const Stop stop = stop_after(rig, GetParam(), [](ModelRig& r) {
    r.driver.farewell([&](ByteView bytes) { r.on_command_bytes(bytes); });
    r.connected = false;
  });
  print("driver ended by SIGTERM", GetParam(), stop);
  expect_bound(stop, 0.1 + 0.02);
}

// Any process upstream of the driver: navigator, mux, smoother, safety controller, teleoperation.
TEST_P(StoppingDistance, AfterDeathOfTheCommanderIsBoundedByTheStaleStop) {
  ModelRig rig({}, ModelParams{});
  const Stop stop = stop_after(rig, GetParam(), [](ModelRig&) {});
  print("source of cmd_vel killed", GetParam(), stop);
  expect_bound(stop, 0.6 + 0.02 + 0.1);
}

// The base falls silent but hears: the driver stops it without waiting for the stale velocity.
TEST_P(StoppingDistance, AfterSilenceOfTheBaseIsBoundedByTheOfflineStop) {
  ModelRig rig({}, ModelParams{});
  const Stop stop = stop_after(rig, GetParam(), [](ModelRig& r) { r.silent = true; });
  print("frames of the base stop coming", GetParam(), stop);
  expect_bound(stop, 0.2 + 0.1);
}

INSTANTIATE_TEST_SUITE_P(Speeds, StoppingDistance, ::testing::Values(0.3, 0.5, 0.7));

TEST(StoppingDistanceWithoutTimeout, AfterDriverDeathIsUnbounded) {
  ModelRig rig({}, ModelParams{});
  const Stop stop = stop_after(rig, 0.5, [](ModelRig& r) { r.connected = false; });
  std::printf("driver killed, base without a timeout of its own: still driving after %.0f s\n",
              stop.time_s);
  EXPECT_GT(stop.way_m, 2.4);
}

}  // namespace
}  // namespace tocsin::kobuki
