// SPDX-License-Identifier: Apache-2.0
#include "mapping/occupancy_grid.hpp"

#include <gtest/gtest.h>

namespace tocsin::mapping {
namespace {

using navigation::Cell;

Scan beam_to(double x_m, double y_m) { return {{0, 0}, {{x_m, y_m}}, {}, {}}; }

TEST(OccupancyGrid, KnowsNothingBeforeTheFirstScan) {
  const OccupancyGrid sut(0.1);
  EXPECT_EQ(sut.at({0, 0}), Cell::unknown);
  EXPECT_EQ(sut.map().cells(), std::vector<Cell>{Cell::unknown});
}

TEST(OccupancyGrid, ABeamFreesWhatItPassesAndOccupiesWhereItEnds) {
  OccupancyGrid sut(0.1);
  sut.insert(beam_to(1, 0.05), {});
  EXPECT_EQ(sut.at({0.05, 0.05}), Cell::free);
  EXPECT_EQ(sut.at({0.95, 0.05}), Cell::free);
  EXPECT_EQ(sut.at({1.05, 0.05}), Cell::occupied);
  EXPECT_EQ(sut.at({1.15, 0.05}), Cell::unknown);
  EXPECT_EQ(sut.at({0.55, 0.25}), Cell::unknown);
}

TEST(OccupancyGrid, ABeamWithoutReturnFreesOnly) {
  OccupancyGrid sut(0.1);
  sut.insert({{0, 0}, {}, {}, {{1.05, 0.05}}}, {});
  EXPECT_EQ(sut.at({0.95, 0.05}), Cell::free);
  EXPECT_EQ(sut.at({1.05, 0.05}), Cell::unknown);
}

TEST(OccupancyGrid, AHitOutweighsThePassesOfItsOwnScan) {
  OccupancyGrid sut(0.1);
  sut.insert({{0, 0}, {{2.05, 0.05}, {1.05, 0.05}, {3.05, 0.05}}, {}, {}}, {});
  EXPECT_EQ(sut.log_odds({1.05, 0.05}), OccupancyParams{}.hit);
  EXPECT_EQ(sut.log_odds({0.55, 0.05}), OccupancyParams{}.pass);
}

TEST(OccupancyGrid, SeesThatSomethingHasGoneHoweverLongItStood) {
  OccupancyGrid sut(0.1);
  for (int i = 0; i < 1000; ++i) sut.insert(beam_to(1, 0.05), {});
  EXPECT_EQ(sut.log_odds({1.05, 0.05}), OccupancyParams{}.limit);
  int scans = 0;
  while (sut.at({1.05, 0.05}) != Cell::free && scans < 1000) {
    sut.insert(beam_to(2, 0.05), {});
    ++scans;
  }
  EXPECT_EQ(scans, 19);  // (350 + 15) / 20
}

TEST(OccupancyGrid, GrowsToAllSidesAndKeepsWhatItKnew) {
  OccupancyGrid sut(0.1);
  sut.insert(beam_to(1, 0.05), {});
  for (const double heading_rad : {pi / 2, pi, -pi / 2}) {
    sut.insert({{0, 0}, {{20, 0.05}}, {}, {}}, {0.02, 0.02, heading_rad});
  }
  EXPECT_EQ(sut.at({1.05, 0.05}), Cell::occupied);
  EXPECT_EQ(sut.at({-19.95, -0.03}), Cell::occupied);
  EXPECT_EQ(sut.at({0.05, -15}), Cell::free);
}

TEST(OccupancyGrid, ItsMapHasWhatIsKnownAndABorder) {
  OccupancyGrid sut(0.1);
  sut.insert(beam_to(1, 0.05), {2, 3, 0});
  const auto map = sut.map();
  EXPECT_EQ(map.grid().width, 13);  // 11 known cells
  EXPECT_EQ(map.grid().height, 3);
  EXPECT_EQ(map.at(geometry::Point{3.05, 3.05}), Cell::occupied);
  EXPECT_EQ(map.at(geometry::Point{2.05, 3.05}), Cell::free);
}

}  // namespace
}  // namespace tocsin::mapping
