// SPDX-License-Identifier: Apache-2.0
#include "navigator/costmap_ports.hpp"

#include <gmock/gmock.h>

#include "seeing_navigator.hpp"

namespace tocsin {
namespace {

using ::testing::Contains;
using ::testing::Not;

struct Caller final : Component {
  using Component::Component;
  void tick(Time) override {}
  Client<ClearGlobalCostmap> clear_global{*this};
  Client<ClearLocalCostmap> clear_local{*this};
};

class CostmapPortsTest : public SeeingNavigatorTest {
 protected:
  /// What the costmap says of a place on the map.
  template <class Topic>
  int percent(SimReader<Topic>& reader, double x_m, double y_m) {
    for (const auto& message : reader.take()) latest_ = message;
    const auto& info = latest_.info();
    const auto cell = [&](double at_m, double origin_m) {
      return static_cast<std::size_t>(std::lround((at_m - origin_m) / info.resolution() - 0.5));
    };
    const std::size_t column = cell(x_m, info.origin().position().x());
    const std::size_t row = cell(y_m, info.origin().position().y());
    return latest_.data().at(row * info.width() + column);
  }
  SimReader<topic::GlobalCostmap> global_{bus_};
  SimReader<topic::LocalCostmap> local_{bus_};
  nav_msgs::msg::OccupancyGrid latest_;
};

TEST_F(CostmapPortsTest, TellWhatTheLaserSeesInTheValuesOfNav2) {
  wall_m_ = 0.25;  // 1.25 m ahead of where it stands
  drive(3);
  EXPECT_EQ(percent(local_, 0.25, 0.05), 100);
  EXPECT_EQ(latest_.header().frame_id(), "map");
  EXPECT_EQ(latest_.info().width(), 31U) << "3 m of cells of 0.1 m";
  EXPECT_EQ(percent(local_, 0.05, 0.05), 99);
  EXPECT_EQ(percent(local_, -1.05, 0.05), 0);
  EXPECT_EQ(percent(global_, 0.25, 0.05), 100);
  EXPECT_EQ(latest_.info().width(), 100U);
  EXPECT_EQ(percent(global_, -4.05, 0.05), 0);
}

TEST_F(CostmapPortsTest, ForgetWhatWasSeenWhenAsked) {
  Caller caller{context_};
  bus_.add(caller);
  wall_m_ = 0.25;
  drive(2);
  ASSERT_EQ(percent(global_, 0.25, 0.05), 100);
  has_laser_ = false;
  for (const bool is_global : {true, false}) {
    if (is_global) caller.clear_global.call({}, bus_.now() + seconds(1));
    if (!is_global) caller.clear_local.call({}, bus_.now() + seconds(1));
    drive(2);
    EXPECT_EQ(percent(global_, 0.25, 0.05), 0);
    EXPECT_EQ(percent(local_, 0.25, 0.05), 0);
    has_laser_ = true;
    drive(2);
    EXPECT_EQ(percent(global_, 0.25, 0.05), 100);
    has_laser_ = false;
  }
  const auto global = caller.clear_global.take(bus_.now());
  const auto local = caller.clear_local.take(bus_.now());
  ASSERT_TRUE(global && local);
  EXPECT_TRUE(global->response && local->response);
  bus_.remove(caller);
}

}  // namespace
}  // namespace tocsin
