// SPDX-License-Identifier: Apache-2.0
#include "link_map/link_map.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <random>
#include <vector>

#include "foundation/numbers.hpp"

namespace tocsin::link_map {
namespace {

using geometry::Point;

const PathLoss truth{{4, 3}, -40, 3};
const Field shadowing{25, 2, 4, 0};

/// Places 0.4 m apart on a way to and fro through 10 x 6 m, with shadowing drawn from the model.
std::vector<Place> drawn(std::uint64_t seed) {
  std::vector<Place> places;
  for (int lane = 0; lane < 5; ++lane) {
    for (int i = 0; i < 25; ++i) {
      const double along_m = 0.4 * (lane % 2 == 0 ? i : 24 - i);
      places.push_back({{along_m, 1.5 * lane}, 0, 1});
    }
  }
  const auto n = static_cast<Eigen::Index>(places.size());
  Eigen::MatrixXd covariance(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = 0; k < n; ++k) {
      const double away_m = geometry::distance(places[static_cast<std::size_t>(i)].at,
                                               places[static_cast<std::size_t>(k)].at);
      covariance(i, k) = shadowing.variance_db2 * std::exp(-away_m / shadowing.range_m) +
                         (i == k ? shadowing.noise_db2 : 0);
    }
  }
  std::mt19937_64 random(seed);
  std::normal_distribution<> normal;
  Eigen::VectorXd white(n);
  for (Eigen::Index i = 0; i < n; ++i) white(i) = normal(random);
  const Eigen::VectorXd field = covariance.llt().matrixL() * white;
  for (Eigen::Index i = 0; i < n; ++i) {
    Place& place = places[static_cast<std::size_t>(i)];
    place.signal_dbm = truth.signal_dbm(place.at) + field(i);
  }
  return places;
}

/// Learns from the places whose index `is_learned`; tells of the others.
struct Told {
  template <class IsLearned>
  Told(const std::vector<Place>& places, const IsLearned& is_learned) {
    std::vector<Place> learned;
    std::vector<Place> others;
    for (std::size_t i = 0; i < places.size(); ++i) {
      (is_learned(i) ? learned : others).push_back(places[i]);
    }
    const LinkMap map(learned);
    field = map.field();
    for (const Place& place : others) {
      const Prediction said = map.predict(place.at);
      const double off_db = place.signal_dbm - said.mean_dbm;
      squares += off_db * off_db;
      within += std::abs(off_db) <= 1.96 * said.deviation_db ? 1 : 0;
      ++count;
    }
  }
  Field field;
  double squares = 0;
  double within = 0;
  double count = 0;
};

TEST(LinkMap, KnowsTheSignalWhereItHasBeenAndHowWell) {
  double squares = 0;
  double within = 0;
  double count = 0;
  double ranges_m = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Told told(drawn(seed), [](std::size_t i) { return i % 4 != 1; });
    squares += told.squares;
    within += told.within;
    count += told.count;
    ranges_m += told.field.range_m / 4;
  }
  // What is drawn anew at each place, 2 dB, nobody can know; shadowing alone is 5 dB.
  EXPECT_LT(std::sqrt(squares / count), 3.5);
  EXPECT_GT(within / count, 0.91) << "more, as there are no walls here";
  EXPECT_GT(ranges_m, shadowing.range_m / 3);
  EXPECT_LT(ranges_m, shadowing.range_m * 3);
}

TEST(LinkMap, SaysHowLittleItKnowsWhereNobodyHasBeen) {
  double within = 0;
  double count = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Told told(drawn(seed), [](std::size_t i) { return i < 62; });
    within += told.within;
    count += told.count;
  }
  EXPECT_GT(within / count, 0.92);
}

TEST(LinkMap, IsLessSureFarAway) {
  const LinkMap sut(drawn(1));
  const double near_db = sut.predict({8, 3}).deviation_db;
  const double far_db = sut.predict({60, 3}).deviation_db;
  EXPECT_LT(near_db, 5);
  EXPECT_GT(far_db, 8);
  EXPECT_LT(sut.predict({60, 3}).mean_dbm, sut.predict({8, 3}).mean_dbm);
}

TEST(LinkMap, ReadingsOfOnePlaceCountAsOne) {
  std::vector<Reading> readings;
  for (int i = 0; i < 100000; ++i) readings.push_back({{0.01 * (i % 10), 0.05}, -50.0 - i % 3});
  const auto places = LinkMap::places_of(readings);
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].readings, 100000);
  EXPECT_NEAR(places[0].signal_dbm, -51, 0.2);
  EXPECT_NEAR(places[0].at.x_m, 0.045, 0.001);
}

TEST(LinkMap, LeavesOutWhatIsNoReading) {
  EXPECT_TRUE(LinkMap::places_of({{{nan, 0}, -50},
                                  {{0, infinity}, -50},
                                  {{0, 0}, nan},
                                  {{0, 0}, 102},
                                  {{0, 0}, -121},
                                  {{1e300, 0}, -50}})
                  .empty());
}

TEST(LinkMap, LearnsFromPlacesThatAllSayTheSame) {
  std::vector<Place> places;
  for (int i = 0; i < 8; ++i) places.push_back({{0.4 * i, 0}, -60, 1});
  const Prediction said = LinkMap(places).predict({1, 0});
  EXPECT_NEAR(said.mean_dbm, -60, 1);
  EXPECT_GT(said.deviation_db, 0.5) << "a flat first stretch is no promise";
}

}  // namespace
}  // namespace tocsin::link_map
