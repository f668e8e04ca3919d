// SPDX-License-Identifier: Apache-2.0
#include "link_map/link_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tocsin::link_map {
namespace {

/// Along x, from an access point at the origin.
std::vector<Place> walk(double length_m) {
  std::vector<Place> places;
  for (double x_m = 1; x_m < length_m; x_m += 0.4) {
    places.push_back({{x_m, 0.1}, -40 - 25 * std::log10(x_m), 1});
  }
  return places;
}

TEST(LinkGrid, CellsTellFromBestToWorstAndWhatIsNotKnown) {
  EXPECT_EQ(cell_of({-30, 3}), 0);
  EXPECT_EQ(cell_of({-10, 3}), 0);
  EXPECT_EQ(cell_of({-60, 3}), 50);
  EXPECT_EQ(cell_of({-90, 3}), 100);
  EXPECT_EQ(cell_of({-110, 3}), 100);
  EXPECT_EQ(cell_of({-60, 8.1}), -1);
  EXPECT_EQ(cell_of({-60, std::nan("")}), -1);
}

TEST(LinkGrid, LiesAroundThePlacesAndGetsWorseAlongTheWay) {
  const auto places = walk(12);
  const LinkGrid grid = grid_of(LinkMap(places), {-66, 2.5}, places);
  ASSERT_EQ(grid.cells.size(), static_cast<std::size_t>(grid.width * grid.height));
  EXPECT_DOUBLE_EQ(std::remainder(grid.origin.x_m, LinkGrid::cell_m), 0);
  EXPECT_LE(grid.origin.x_m, 1 - LinkGrid::around_m);
  EXPECT_GE(grid.origin.x_m + grid.width * LinkGrid::cell_m, 11.4 + LinkGrid::around_m);
  const auto at = [&](double x_m, double y_m) {
    const auto column = static_cast<int>((x_m - grid.origin.x_m) / LinkGrid::cell_m);
    const auto row = static_cast<int>((y_m - grid.origin.y_m) / LinkGrid::cell_m);
    return grid.cells[static_cast<std::size_t>(row * grid.width + column)];
  };
  EXPECT_GE(at(1.2, 0.1), 0);
  EXPECT_GT(at(11, 0.1), at(1.2, 0.1) + 20);
  EXPECT_EQ(at(15, 3.5), -1) << "nobody has been there";
  ASSERT_EQ(grid.risk.size(), grid.cells.size());
  const auto risk_at = [&](double x_m) {
    const auto column = static_cast<int>((x_m - grid.origin.x_m) / LinkGrid::cell_m);
    const auto row = static_cast<int>((0.1 - grid.origin.y_m) / LinkGrid::cell_m);
    return grid.risk[static_cast<std::size_t>(row * grid.width + column)];
  };
  EXPECT_LT(risk_at(1.2), 2);
  EXPECT_NEAR(risk_at(11), 50, 25);
}

TEST(LinkGrid, OfALongWayIsTheMiddle) {
  const auto places = walk(300);
  const LinkGrid grid = grid_of(LinkMap(places), {-66, 2.5}, places);
  EXPECT_LE(grid.width * LinkGrid::cell_m, LinkGrid::most_side_m + 1);
}

}  // namespace
}  // namespace tocsin::link_map
