// SPDX-License-Identifier: Apache-2.0
#include "auto_docking/light_sweep.hpp"

#include <gtest/gtest.h>

#include "kobuki_protocol/dimensions.hpp"
#include "kobuki_protocol/odometry.hpp"

namespace tocsin {
namespace {

using geometry::wrap_angle;

/// A base that turns by a degree a frame, at a light seen within a half view around a bearing.
struct Turning {
  double bearing_deg = 90;
  double half_view_deg = 20;
  double heading_deg = 0;
  int lit = 0;
  int misses_every = 0;  ///< of so many lit frames one is missed
  LightSweep sut{Turn::left};

  /// Until the sweep is complete, for at most so many frames. The frames it took.
  int run(int frames) {
    int taken = 0;
    for (; taken < frames && !sut.complete(); ++taken) {
      const double off = geometry::wrap_angle((heading_deg - bearing_deg) * degree) / degree;
      bool seen = std::abs(off) <= half_view_deg;
      if (seen && misses_every > 0 && ++lit % misses_every == 0) seen = false;
      sut.update(geometry::wrap_angle(heading_deg * degree), seen ? 16 : 0);
      heading_deg += sut.turn() == Turn::left ? 1 : -1;
    }
    return taken;
  }
  double found_deg() const { return sut.bearing_rad() / degree; }
};

TEST(LightSweep, FindsTheMiddleOfTheLight) {
  struct {
    double bearing_deg;
    double half_view_deg;
    int misses_every;
    double within_deg;
  } const lights[] = {
      {90, 20, 0, 0.01}, {90, 5, 0, 0.01}, {90, 60, 0, 0.01}, {90, 20, 3, 1}, {180, 20, 0, 0.01}};
  for (const auto& [bearing_deg, half_view_deg, misses_every, within_deg] : lights) {
    Turning base;
    base.bearing_deg = bearing_deg;
    base.half_view_deg = half_view_deg;
    base.misses_every = misses_every;
    const int frames = base.run(1000);
    EXPECT_TRUE(base.sut.complete());
    EXPECT_NEAR(std::abs(base.found_deg()), bearing_deg, within_deg);
    if (misses_every == 0 && bearing_deg == 90) {
      EXPECT_EQ(frames, bearing_deg + half_view_deg + 20 + 1) << "20 dark ones after the light";
    }
  }
}

TEST(LightSweep, TurnsBackWhenTheLightWasInViewFromTheStart) {
  Turning base;
  base.heading_deg = 100;
  base.run(31);
  EXPECT_EQ(base.sut.turn(), Turn::right);
  EXPECT_FALSE(base.sut.complete());
  base.run(1000);
  EXPECT_NEAR(base.found_deg(), 90, 0.01);
  EXPECT_EQ(base.sut.turn(), Turn::right);
}

TEST(LightSweep, TakesALightForGoneAfterTwentyUpdates) {
  LightSweep sut(Turn::right);
  for (int i = 0; i < 20; ++i) sut.update(0, 0);
  sut.update(0.1, 8);
  for (int i = 0; i < 19; ++i) sut.update(0.2, 0);
  EXPECT_FALSE(sut.complete());
  sut.update(0.2, 0);
  EXPECT_TRUE(sut.complete());
}

TEST(LightSweep, CollectsAllSignalsOfThePassage) {
  LightSweep sut(Turn::left);
  for (int i = 0; i < 20; ++i) sut.update(0, 0);
  sut.update(0.1, 16);
  sut.update(0.2, 8);
  for (int i = 0; i < 20; ++i) sut.update(0.3, 0);
  EXPECT_EQ(sut.signals(), 24);
}

TEST(LightSweep, IsNeverCompleteWithoutLight) {
  Turning base;
  base.half_view_deg = -1;
  EXPECT_EQ(base.run(1000), 1000);
  EXPECT_FALSE(base.sut.complete());
}

}  // namespace
}  // namespace tocsin
