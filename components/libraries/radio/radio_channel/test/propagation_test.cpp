// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/propagation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/wall.hpp"

namespace tocsin::radio {
namespace {

constexpr Time t0{};
const geometry::Wall wall{2, -1, 2, 1, 6.9};  // between x < 2 and x > 2, for |y| < 1

ChannelParams plain() {
  ChannelParams params;
  params.shadowing_sigma_db = 0;
  params.rician_k_clear_db = 60;
  params.rician_k_walled_db = 60;
  return params;
}

double loss_at(const ChannelParams& params, const std::vector<geometry::Wall>& walls, double x,
               double y) {
  Propagation sut(params, walls, 1, t0);
  sut.set_position(x, y);
  return sut.path_loss_db();
}

TEST(PathLoss, FollowsTwoExponents) {
  EXPECT_NEAR(loss_at(plain(), {}, 1, 0), 40.2, 1e-9);
  EXPECT_NEAR(loss_at(plain(), {}, 0, 5), 40.2 + 20 * std::log10(5.0), 1e-9);
  EXPECT_NEAR(loss_at(plain(), {}, 50, 0), 40.2 + 20 * std::log10(5.0) + 28, 1e-9);
}

TEST(PathLoss, DoesNotFallBelowOneMetre) {
  EXPECT_NEAR(loss_at(plain(), {}, 0, 0), 40.2, 1e-9);
  EXPECT_NEAR(loss_at(plain(), {}, 0.5, 0), 40.2, 1e-9);
}

TEST(PathLoss, AddsEveryWallThatIsCrossed) {
  const geometry::Wall second{3, -1, 3, 1, 3.4};
  const double clear = loss_at(plain(), {}, 4, 0);
  EXPECT_NEAR(loss_at(plain(), {wall, second}, 4, 0), clear + 10.3, 1e-9);
  EXPECT_NEAR(loss_at(plain(), {wall, second}, 2.5, 0), loss_at(plain(), {}, 2.5, 0) + 6.9, 1e-9);
}

TEST(Propagation, AddsUpToReceivedPowerAndSnr) {
  Propagation sut(plain(), {}, 1, t0);
  sut.set_position(1, 0);
  EXPECT_NEAR(sut.mean_rssi_dbm(), 16 - 40.2, 1e-9);
  EXPECT_NEAR(sut.mean_snr_db(), 16 - 40.2 + 94, 1e-9);
  EXPECT_NEAR(sut.rssi_dbm(t0), sut.mean_rssi_dbm(), 0.05);
}

TEST(Propagation, AnotherRadioOfTheSiteSharesAsMuchShadowingAsItSays) {
  ChannelParams first = plain();
  first.shadowing_sigma_db = 6;
  for (const double share : {0.0, 0.5, 0.9}) {
    ChannelParams second = first;
    second.shared_shadowing = share;
    double product = 0;
    double one = 0;
    double other = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
      Propagation a(first, {}, seed, t0);
      Propagation b(second, {}, seed, t0);
      for (Propagation* sut : {&a, &b}) sut->set_position(3, 1);
      const double x = a.mean_rssi_dbm() + a.path_loss_db() - 16;
      const double y = b.mean_rssi_dbm() + b.path_loss_db() - 16;
      product += x * y;
      one += x * x;
      other += y * y;
    }
    EXPECT_NEAR(product / std::sqrt(one * other), std::sqrt(share), 0.12) << share;
    EXPECT_NEAR(std::sqrt(other / one), 1, 0.12) << "as strong";
  }
}

TEST(Propagation, FadesMoreBehindAWall) {
  ChannelParams params = plain();
  params.rician_k_walled_db = 0;
  Propagation sut(params, {wall}, 1, t0);
  const auto deviation = [&sut](double x_m) {
    double square = 0;
    for (int i = 0; i < 200; ++i) {
      sut.set_position(x_m, 0.002 * i);
      square += std::pow(sut.rssi_dbm(t0 + seconds(i)) - sut.mean_rssi_dbm(), 2);
    }
    return std::sqrt(square / 200);
  };
  EXPECT_LT(deviation(1.5), 0.1);
  EXPECT_GT(deviation(2.5), 3);
}

TEST(Propagation, HoldsFadingForFourMilliseconds) {
  ChannelParams params;
  params.environment_doppler_hz = 20;
  Propagation sut(params, {}, 1, t0);
  const double here = sut.rssi_dbm(t0);
  EXPECT_EQ(sut.rssi_dbm(t0 + Duration{3'999'999}), here);
  EXPECT_NE(sut.rssi_dbm(t0 + Duration{4'000'000}), here);
}

TEST(Propagation, FadesAnewAfterAMoveAndWhenTimeGoesBack) {
  ChannelParams params;
  params.environment_doppler_hz = 20;
  Propagation sut(params, {}, 1, t0);
  const double here = sut.rssi_dbm(t0);
  EXPECT_NE(sut.rssi_dbm(t0 + seconds(0.01)), here);
  EXPECT_EQ(sut.rssi_dbm(t0 + seconds(0.001)), here);
  sut.set_position(0.03, 0);
  EXPECT_NE(sut.rssi_dbm(t0), here);
  sut.set_position(0, 0);
  EXPECT_EQ(sut.rssi_dbm(t0), here);
}

TEST(Propagation, IgnoresAPositionThatIsNotFiniteOrTooFar) {
  Propagation sut(plain(), {}, 1, t0);
  sut.set_position(3, 4);
  sut.set_position(std::nan(""), 1);
  sut.set_position(1, HUGE_VAL);
  sut.set_position(1.001e6, 1);
  sut.set_position(1, -1e300);
  EXPECT_EQ(sut.x_m(), 3);
  EXPECT_EQ(sut.y_m(), 4);
  sut.set_position(-1e6, 1e6);
  EXPECT_EQ(sut.x_m(), -1e6);
}

}  // namespace
}  // namespace tocsin::radio
