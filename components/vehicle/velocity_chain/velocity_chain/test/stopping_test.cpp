// SPDX-License-Identifier: Apache-2.0
/// How far the model of the base goes from 0.5 m/s after a part of the chain has died.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <functional>

#include "velocity_chain.hpp"

namespace tocsin {
namespace {

struct Stop {
  double time_s = 0;
  double way_m = 0;
};

/// Drives for two seconds, lets something happen, and waits for the base to stand.
Stop stop_after(VelocityChain& sut, const char* what, const std::function<void()>& happen) {
  const auto source = [] { return geometry::Twist{0.5, 0}; };
  while (sut.model.velocity().linear_mps < 0.499) sut.step(source);
  for (int i = 0; i < 50; ++i) sut.step(source);
  happen();
  const double from_m = sut.model.pose().x_m;
  const Time since = sut.now;
  while (sut.model.velocity().linear_mps > 0 && sut.now - since < seconds(10)) sut.step(source);
  const Stop stop{to_seconds(sut.now - since), sut.model.pose().x_m - from_m};
  std::printf("%s: stands after %.2f s and %.2f m\n", what, stop.time_s, stop.way_m);
  return stop;
}

TEST(Stopping, WhenAPartDies) {
  using Alive = VelocityChain::Alive;
  struct {
    const char* what;
    bool Alive::*part;
    double within_s;
    double within_m;
  } const deaths[] = {{"source", &Alive::source, 0.85, 0.3},
                      {"mux", &Alive::mux, 0.85, 0.3},
                      {"collision brake", &Alive::brake, 0.85, 0.3},
                      {"laser", &Alive::laser, 1.3, 0.5},
                      {"smoother", &Alive::smoother, 1.1, 0.46},
                      {"safety controller", &Alive::safety, 1.1, 0.46},
                      {"their process, by the timeout of the base", &Alive::driver, 0.95, 0.36}};
  for (const auto& [what, part, within_s, within_m] : deaths) {
    ModelParams base;
    if (part == &Alive::driver) base.command_timeout_s = 0.5;
    VelocityChain sut(open_floor(), {}, base);
    sut.add_brake();
    bool& alive = sut.alive.*part;
    const Stop stop = stop_after(sut, what, [&] { alive = false; });
    EXPECT_LT(stop.time_s, within_s) << what;
    EXPECT_LT(stop.way_m, within_m) << what;
  }
}

TEST(Stopping, AtTheEmergencyStop) {
  VelocityChain sut(open_floor());
  const Stop stop = stop_after(sut, "emergency stop", [&] { sut.press_emergency_stop(true); });
  EXPECT_LT(stop.time_s, 0.5);
  EXPECT_LT(stop.way_m, 0.15);
  const double at_m = sut.model.pose().x_m;
  for (int i = 0; i < 500; ++i) sut.step([] { return geometry::Twist{0.5, 0}; });
  EXPECT_EQ(sut.model.pose().x_m, at_m);
  sut.press_emergency_stop(false);
  for (int i = 0; i < 200; ++i) sut.step([] { return geometry::Twist{0.5, 0}; });
  EXPECT_GT(sut.model.pose().x_m, at_m + 0.3);
}

TEST(Stopping, AtABumpWithoutPushing) {
  SafetyController::Params safety;
  safety.stop_only = true;
  VelocityChain sut(walled({{1.5, -2, 1.5, 2, 0}}), safety);
  bool pushed_long = false;
  int pushing = 0;
  for (int i = 0; i < 1000; ++i) {
    sut.step([] { return geometry::Twist{0.3, 0}; });
    pushing = sut.bumper != 0 && sut.commanded().linear_mps > 0 ? pushing + 1 : 0;
    pushed_long = pushed_long || pushing > 5;
  }
  EXPECT_NE(sut.bumper, 0);
  EXPECT_FALSE(pushed_long);
  for (int i = 0; i < 200; ++i) sut.step([] { return geometry::Twist{-0.2, 0}; });
  EXPECT_EQ(sut.bumper, 0);
}

TEST(Stopping, BacksOffFromABumpByItself) {
  VelocityChain sut(walled({{1.5, -2, 1.5, 2, 0}}));
  double farthest_m = 0;
  for (int i = 0; i < 600; ++i) {
    sut.step([] { return geometry::Twist{0.3, 0}; });
    farthest_m = std::max(farthest_m, sut.model.pose().x_m);
    if (farthest_m > 1.2 && sut.bumper == 0 && sut.model.velocity().linear_mps < 0) return;
  }
  FAIL() << "it never drove backwards";
}

}  // namespace
}  // namespace tocsin
