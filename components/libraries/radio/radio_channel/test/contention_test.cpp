// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/contention.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "radio_channel/ofdm.hpp"

namespace tocsin::radio {
namespace {

constexpr Duration frame{500'000};

TEST(Saturation, OfOneStationIsWithoutCollision) {
  const Saturation sut = saturation(1);
  EXPECT_NEAR(sut.collision, 0, 1e-9);
  EXPECT_NEAR(sut.attempt, 2.0 / 17, 1e-9);  // mean backoff of 7.5 slots
}

TEST(Saturation, SolvesBianchisEquations) {
  for (const int n : {2, 5, 10, 50}) {
    const Saturation sut = saturation(n);
    const double p = sut.collision;
    EXPECT_NEAR(p, 1 - std::pow(1 - sut.attempt, n - 1), 1e-9);
    const double tau = 2 * (1 - 2 * p) / ((1 - 2 * p) * 17 + p * 16 * (1 - std::pow(2 * p, 6)));
    EXPECT_NEAR(sut.attempt, tau, 1e-6) << n;
  }
}

TEST(Saturation, CollidesMoreWithMoreStations) {
  double before = 0;
  for (int n = 2; n < 40; ++n) {
    EXPECT_GT(saturation(n).collision, before);
    before = saturation(n).collision;
  }
}

TEST(BackgroundLoad, OfZeroDoesNothing) {
  RandomStream random(1, 1);
  const BackgroundLoad sut(0, 5, frame);
  EXPECT_EQ(sut.collision(), 0);
  EXPECT_EQ(sut.until_idle(random), Duration::zero());
  EXPECT_EQ(sut.interruptions(seconds(1), random), Duration::zero());
}

TEST(BackgroundLoad, CollidesLikeOneMoreStationInSaturation) {
  EXPECT_NEAR(BackgroundLoad(0.95, 3, frame).collision(), saturation(4).collision, 1e-9);
  EXPECT_LT(BackgroundLoad(0.3, 3, frame).collision(), saturation(4).collision / 2);
}

TEST(BackgroundLoad, IsFoundBusyAsOftenAsItIs) {
  RandomStream random(2, 1);
  const BackgroundLoad sut(0.3, 3, frame);
  int busy = 0;
  for (int i = 0; i < 10000; ++i) {
    const Duration wait = sut.until_idle(random);
    EXPECT_LE(wait, frame);
    busy += wait > Duration::zero() ? 1 : 0;
  }
  EXPECT_NEAR(busy, 3000, 4 * std::sqrt(10000 * 0.3 * 0.7));
}

TEST(BackgroundLoad, TakesItsShareWhileWeWait) {
  RandomStream random(3, 1);
  const BackgroundLoad sut(0.3, 30, frame);
  double taken_s = 0;
  for (int i = 0; i < 20000; ++i) taken_s += to_seconds(sut.interruptions(frame, random));
  // our 0.5 ms of every 1/0.7 of it, plus the gap before each background frame
  EXPECT_NEAR(taken_s / 20000, 0.3 / 0.7 * to_seconds(frame + difs), 0.00001);
}

TEST(BackgroundLoad, LeavesUsATurnForEachOfTheirs) {
  RandomStream random(4, 1);
  const BackgroundLoad sut(0.95, 2, frame);
  double taken_s = 0;
  for (int i = 0; i < 20000; ++i) taken_s += to_seconds(sut.interruptions(frame, random));
  EXPECT_NEAR(taken_s / 20000, 2 * to_seconds(frame + difs), 0.00003);
}

}  // namespace
}  // namespace tocsin::radio
