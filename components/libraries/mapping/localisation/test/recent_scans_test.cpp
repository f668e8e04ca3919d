// SPDX-License-Identifier: Apache-2.0
#include "localisation/recent_scans.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "foundation/numbers.hpp"
#include "localisation/beam_model.hpp"

namespace tocsin::localisation {
namespace {

/// A wall along x at y = 2 m, from x = 0 to 10 m.
navigation::OccupancyMap one_wall() {
  const navigation::Grid grid{240, 80, 0.05, {-1, -1}};
  std::vector<navigation::Cell> cells(grid.size(), navigation::Cell::free);
  for (int i = 0; i <= 400; ++i) {
    cells[grid.offset(*grid.cell_of({i * 0.025, 2}))] = navigation::Cell::occupied;
  }
  return {grid, cells};
}

/// Of a vehicle that sees the wall `away_m` to its left.
laser::Scan scan_at(double away_m) {
  laser::Scan scan;
  for (int i = -20; i <= 20; ++i) scan.hits.push_back({i * 0.05, away_m});
  return scan;
}

struct RecentScansTest : ::testing::Test {
  const navigation::OccupancyMap map = one_wall();
  const DistanceMap distances{map};
  const BeamModel model{map, distances};
  RecentScans sut;
};

TEST_F(RecentScansTest, BeamsTellWallsFromWhatIsBeforeThemAndBehindThem) {
  const geometry::Pose here{5, 0.5, 0};
  const Evidence at_wall = model.evidence_of(scan_at(1.5), here);
  const Evidence before = model.evidence_of(scan_at(1), here);
  const Evidence behind = model.evidence_of(scan_at(2.2), here);
  EXPECT_DOUBLE_EQ(at_wall.explained, 1);
  EXPECT_DOUBLE_EQ(before.explained + before.through, 0);
  EXPECT_DOUBLE_EQ(behind.through, 1);
  EXPECT_GT(at_wall.log_likelihood, before.log_likelihood + 1);
  EXPECT_GT(before.log_likelihood, behind.log_likelihood + 1);
}

TEST_F(RecentScansTest, ANearMissSpeaksForAPoseLessThanAHit) {
  const geometry::Pose here{5, 0.5, 0};
  const double exact = model.evidence_of(scan_at(1.5), here).log_likelihood;
  const double near = model.evidence_of(scan_at(1.39), here).log_likelihood;
  EXPECT_LT(near, exact - 0.1);
  EXPECT_GT(near, model.evidence_of(scan_at(1), here).log_likelihood);
}

TEST_F(RecentScansTest, AGuessIsAskedForWhatWasSeenBefore) {
  sut.add(scan_at(1.5));   // at (3, 0.5)
  sut.move({0, -0.5, 0});  // away from the wall
  sut.add(scan_at(2));     // at (3, 0)
  const geometry::Pose truth{3, 0, 0};
  const geometry::Pose turned{3, 0, 90 * degree};
  EXPECT_GT(sut.advantage(model, truth, turned, -infinity), 10);
  EXPECT_DOUBLE_EQ(sut.advantage(model, truth, truth, -infinity), 0);
  EXPECT_LT(sut.advantage(model, truth, std::nullopt, -infinity), 0) << "no scan is certain";
}

TEST_F(RecentScansTest, WhatWasSeenFadesAndIsForgotten) {
  const geometry::Pose truth{3, 0.5, 0};
  const geometry::Pose turned{3, 0.5, 90 * degree};
  sut.add(scan_at(1.5));
  const double of_one = sut.advantage(model, truth, turned, -infinity);
  for (int i = 0; i < 100; ++i) sut.add(scan_at(1.5));
  const double of_all = sut.advantage(model, truth, turned, -infinity);
  EXPECT_GT(of_all, 5 * of_one);
  EXPECT_LT(of_all, of_one / (1 - RecentScans::fading));
  sut.clear();
  EXPECT_TRUE(sut.empty());
  EXPECT_DOUBLE_EQ(sut.advantage(model, truth, turned, -infinity), 0);
}

TEST_F(RecentScansTest, StopsAskingWhereThereIsNoHope) {
  const geometry::Pose truth{3, 0.5, 0};
  const geometry::Pose turned{3, 0.5, 90 * degree};
  for (int i = 0; i < 20; ++i) sut.add(scan_at(1.5));
  const double all = sut.advantage(model, turned, truth, -infinity);
  const double some = sut.advantage(model, turned, truth, -20);
  EXPECT_LT(some, -20);
  EXPECT_GT(some, all);
}

}  // namespace
}  // namespace tocsin::localisation
