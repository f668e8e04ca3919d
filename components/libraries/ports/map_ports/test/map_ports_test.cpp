// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "map_ports/map_input.hpp"
#include "map_ports/map_output.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using navigation::Cell;
using navigation::TileMap;

struct Publisher final : Component {
  using Component::Component;
  void tick(Time now) override {
    map.publish(wall(now), now);
    wake_at(now + seconds(0.1));
  }
  MapOutput map{*this, 0.1};
};
struct Follower final : Component {
  using Component::Component;
  void tick(Time) override { changes += map.take() ? 1 : 0; }
  MapInput map{*this};
  int changes = 0;
};

class MapPortsTest : public ::testing::Test {
 protected:
  MapPortsTest() {
    bus_.add(publisher_);
    bus_.add(follower_);
  }
  void put(TileMap::Index index, Cell cell, double wait_s = 3) {
    TileMap::Tile tile(TileMap::side * TileMap::side, Cell::unknown);
    tile[1] = cell;
    (void)publisher_.map.put(index, std::move(tile));
    bus_.run_for(seconds(wait_s));
  }
  [[nodiscard]] Cell seen(double x_m, double y_m) const {
    return follower_.map.map()->at(geometry::Point{x_m, y_m});
  }
  SimBus bus_;
  Context publisher_context_{bus_, "mapper", Role::uxv};
  Context follower_context_{bus_, "explorer", Role::uxv};
  Publisher publisher_{publisher_context_};
  Follower follower_{follower_context_};
  SimReader<topic::Map> maps_{bus_};
  SimReader<topic::MapUpdates> updates_{bus_};
};

TEST_F(MapPortsTest, IsWholeWhenItGrowsAndInTilesWhereItChanges) {
  bus_.run_for(seconds(3));
  EXPECT_TRUE(maps_.take().empty());
  put({0, 0}, Cell::occupied);
  EXPECT_EQ(maps_.take().size(), 1U);
  EXPECT_EQ(seen(0.15, 0.05), Cell::occupied);
  put({-1, 2}, Cell::free);
  EXPECT_EQ(maps_.take().size(), 1U);
  EXPECT_EQ(updates_.take().size(), 0U);
  put({0, 0}, Cell::free, 1);
  put({0, 0}, Cell::free, 0.5);
  EXPECT_EQ(maps_.take().size(), 0U);
  EXPECT_EQ(updates_.take().size(), 1U);
  EXPECT_EQ(seen(0.15, 0.05), Cell::free);
  EXPECT_EQ(seen(-6.25, 12.85), Cell::free);
  EXPECT_EQ(follower_.changes, 3);
}

TEST_F(MapPortsTest, WhoComesLateHasTheMapAsItIs) {
  put({0, 0}, Cell::occupied);
  put({0, 0}, Cell::free);
  bus_.run_for(seconds(5));
  const auto maps = maps_.take();
  ASSERT_EQ(maps.size(), 2U);
  EXPECT_EQ(maps.back().data()[1], 0);
  bus_.run_for(seconds(100));
  EXPECT_TRUE(maps_.take().empty());
}

TEST_F(MapPortsTest, BeginsAnew) {
  put({0, 0}, Cell::occupied);
  publisher_.map.begin(0.05);
  put({0, 0}, Cell::free);
  EXPECT_EQ(maps_.take().size(), 2U);
  EXPECT_EQ(follower_.map.map()->grid().resolution_m, 0.05F);
  EXPECT_EQ(seen(0.075, 0.025), Cell::free);
}

TEST_F(MapPortsTest, PassesOverWhatIsNoMap) {
  put({0, 0}, Cell::occupied);
  topic::Map::Message turned = map_message(publisher_.map.tiles().map());
  turned.info().origin().orientation().z(0.1);
  bus_.publish<topic::Map>(turned);
  topic::Map::Message cut = map_message(publisher_.map.tiles().map());
  cut.data().pop_back();
  bus_.publish<topic::Map>(cut);
  topic::MapUpdates::Message outside;
  outside.x(64);
  outside.width(1);
  outside.height(1);
  outside.data({0});
  bus_.publish<topic::MapUpdates>(outside);
  bus_.run_for(seconds(1));
  EXPECT_EQ(follower_.changes, 1);
  EXPECT_EQ(seen(0.15, 0.05), Cell::occupied);
}

}  // namespace
}  // namespace tocsin
