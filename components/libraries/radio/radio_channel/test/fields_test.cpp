// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "radio_channel/fading.hpp"
#include "radio_channel/shadowing.hpp"

namespace tocsin::radio {
namespace {

constexpr int seeds = 1500;
constexpr double sigma_db = 5;
constexpr double distance_m = 2;

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double mean_product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum / static_cast<double>(a.size());
}

/// The field at one place, over seeds.
std::vector<double> ensemble(double x_m, double y_m) {
  std::vector<double> values;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    values.push_back(ShadowingField(sigma_db, distance_m, seed).at(x_m, y_m));
  }
  return values;
}

TEST(Shadowing, HasMeanZeroAndItsVarianceOnTheGrid) {
  const auto sut = ensemble(4.0, -2.0);
  EXPECT_NEAR(mean(sut), 0, 3.5 * sigma_db / std::sqrt(seeds));
  EXPECT_NEAR(mean_product(sut, sut), sigma_db * sigma_db, 0.13 * sigma_db * sigma_db);
}

TEST(Shadowing, LosesLessThanAFifthOfItsVarianceBetweenGridPoints) {
  const auto sut = ensemble(4.1, -2.1);  // the middle of a cell
  EXPECT_GT(mean_product(sut, sut), 0.8 * sigma_db * sigma_db);
  EXPECT_LT(mean_product(sut, sut), 1.05 * sigma_db * sigma_db);
}

TEST(Shadowing, IsCorrelatedByGudmundsonsLawInEveryDirection) {
  const auto origin = ensemble(0, 0);
  for (const double d : {0.4, 1.0, 2.0, 4.0}) {
    for (const auto& other : {ensemble(d, 0), ensemble(0, d)}) {
      const double correlation = mean_product(origin, other) / (sigma_db * sigma_db);
      EXPECT_NEAR(correlation, std::exp(-d / distance_m), 0.1) << d;
    }
  }
}

TEST(Shadowing, IsTheSameAtEveryVisit) {
  ShadowingField sut(sigma_db, distance_m, 7);
  const double first = sut.at(3.3, 4.4);
  (void)sut.at(-100, 20);
  EXPECT_EQ(sut.at(3.3, 4.4), first);
  EXPECT_EQ(ShadowingField(sigma_db, distance_m, 7).at(3.3, 4.4), first);
  EXPECT_NE(ShadowingField(sigma_db, distance_m, 8).at(3.3, 4.4), first);
}

TEST(Shadowing, IsContinuousAcrossCells) {
  ShadowingField sut(sigma_db, distance_m, 7);
  for (double x = -3; x < 3; x += 0.01) {
    EXPECT_NEAR(sut.at(x, 0.1), sut.at(x + 1e-9, 0.1), 1e-6);
  }
}

TEST(Shadowing, IsNothingWithoutSigma) { EXPECT_EQ(ShadowingField(0, 2, 1).at(3, 4), 0); }

struct Power {
  double mean;
  double deviation_db;
};

struct Place {
  double x_m;
  double y_m;
};

double gain_db(RicianFading& fading, double k_db, Place place, double t_s) {
  fading.move_to(place.x_m, place.y_m, k_db);
  return fading.gain_db(t_s);
}

Power fading_power(double k_db) {
  std::vector<double> db;
  std::vector<double> linear;
  for (unsigned seed = 0; seed < 100; ++seed) {
    RicianFading sut(0.123, 1, seed);
    for (int i = 0; i < 100; ++i) {
      db.push_back(gain_db(sut, k_db, {0.31 * i, 0.17 * i}, 0.7 * i));
      linear.push_back(std::pow(10, db.back() / 10));
    }
  }
  const double m = mean(db);
  return {mean(linear), std::sqrt(mean_product(db, db) - m * m)};
}

// Standard deviations of Rician power in dB for K = 0, 3, 6 dB: 5.1, 4.4, 3.3.
TEST(Fading, HasUnitPowerAndRiciansSpread) {
  for (const auto& [k_db, deviation_db] : {std::pair{0.0, 5.1}, {3.0, 4.4}, {6.0, 3.3}}) {
    const Power sut = fading_power(k_db);
    EXPECT_NEAR(sut.mean, 1, 0.03) << k_db;
    EXPECT_NEAR(sut.deviation_db, deviation_db, 0.25) << k_db;
  }
}

TEST(Fading, VanishesWhenTheDirectWaveDominates) {
  RicianFading sut(0.123, 1, 3);
  EXPECT_NEAR(gain_db(sut, 60, {1, 2}, 3), 0, 0.05);
}

TEST(Fading, ChangesWithPositionAndTimeButSlowly) {
  RicianFading sut(0.123, 1, 3);
  const double here = gain_db(sut, 3, {1, 2}, 10);
  EXPECT_EQ(gain_db(sut, 3, {1, 2}, 10), here);
  EXPECT_NEAR(gain_db(sut, 3, {1, 2}, 10.002), here, 0.5);
  EXPECT_NE(gain_db(sut, 3, {1, 2}, 10.5), here);
  EXPECT_NE(gain_db(sut, 3, {1.06, 2}, 10), here);
}

TEST(Fading, StandsStillWithoutMovement) {
  RicianFading sut(0.123, 0, 3);
  EXPECT_EQ(gain_db(sut, 3, {1, 2}, 10), gain_db(sut, 3, {1, 2}, 1000));
}

}  // namespace
}  // namespace tocsin::radio
