// SPDX-License-Identifier: Apache-2.0
#include "navigator/surroundings.hpp"

#include <gtest/gtest.h>

#include "vehicle.hpp"

namespace tocsin {
namespace {

/// The link is lost in the lower half, in the middle of 8 m x 4 m.
navigation::LinkRisk dead_middle() {
  const Grid grid{16, 8, 0.5, {0, 0}};
  std::vector<std::int8_t> percent;
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const auto p = grid.centre({column, row});
      percent.push_back(p.x_m > 3 && p.x_m < 5 && p.y_m < 2 ? 95 : 0);
    }
  }
  return {grid, percent};
}

class SurroundingsTest : public ::testing::Test {
 protected:
  void start(double link_detour) {
    Surroundings::Params params;
    params.link_detour = link_detour;
    const OccupancyMap floor = floor_with_wall(0);
    const navigation::InflationParams inflation;
    sut_.emplace(params, inflation, floor,
                 std::make_shared<const navigation::CostMap>(floor, inflation));
  }
  [[nodiscard]] double silent_m(const geometry::Path& path) const {
    return dead_middle().silent_m(path);
  }
  const geometry::Point from_{1, 1.2};
  const geometry::Point to_{7, 1.2};
  std::optional<Surroundings> sut_;
};

TEST_F(SurroundingsTest, PlansRoundWhereTheLinkIsLost) {
  start(0.2);
  EXPECT_GT(silent_m(*sut_->plan(from_, to_, t0)), 1.5) << "it is not known yet";
  EXPECT_FALSE(sut_->choice());
  sut_->set_link(dead_middle());
  EXPECT_FALSE(sut_->wants_plan(t0 + seconds(0.5)));
  EXPECT_TRUE(sut_->wants_plan(t0 + seconds(1)));
  EXPECT_LT(silent_m(*sut_->plan(from_, to_, t0 + seconds(1))), 0.3);
  EXPECT_FALSE(sut_->wants_plan(t0 + seconds(9)));
  ASSERT_TRUE(sut_->choice());
  EXPECT_GT(sut_->choice()->shortest.silent_m, 1.5);
}

TEST_F(SurroundingsTest, WithoutADetourTheLinkChangesNothing) {
  start(0);
  sut_->set_link(dead_middle());
  EXPECT_GT(silent_m(*sut_->plan(from_, to_, t0)), 1.5);
  EXPECT_FALSE(sut_->choice());
  EXPECT_FALSE(sut_->wants_plan(t0 + seconds(9)));
  EXPECT_TRUE(sut_->link()) << "for who wants to be heard again";
}

}  // namespace
}  // namespace tocsin
