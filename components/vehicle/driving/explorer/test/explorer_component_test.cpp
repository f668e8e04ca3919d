// SPDX-License-Identifier: Apache-2.0
// The explorer beside a navigator that drives as fast as light over a floor of 4 m by 2 m.
#include "explorer/explorer_component.hpp"

#include <gtest/gtest.h>

#include "geometry/pose_message.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using Navigate = action::NavigateToPose;

class Navigator final : public Component {
 public:
  explicit Navigator(Context& context) : Component(context) {}
  void tick(Time now) override {
    while (const auto asked = server_.take(now)) {
      if (!rejection.empty()) {
        Navigate::Result why;
        why.error_msg(rejection);
        server_.reject(std::move(why));
        continue;
      }
      server_.accept(now);
      goal = asked->id;
      goals.push_back(geometry::pose_in(asked->goal->pose().pose()));
    }
    if (goal && server_.is_canceling(*goal)) {
      server_.canceled(*std::exchange(goal, std::nullopt), {}, now);
      ++canceled;
    }
    if (goal && arrives) server_.succeed(*std::exchange(goal, std::nullopt), {}, now);
  }
  std::optional<GoalId> goal;
  std::vector<geometry::Pose> goals;
  std::string rejection;
  bool arrives = true;
  int canceled = 0;

 private:
  ActionServer<Navigate> server_{*this};
};

class Caller final : public Component {
 public:
  explicit Caller(Context& context) : Component(context) {}
  void tick(Time now) override {
    while (const auto outcome = client.take(now)) answers += outcome->response ? 1 : 0;
  }
  Client<Explore> client{*this};
  int answers = 0;
};

class ExplorerComponentTest : public ::testing::Test {
 protected:
  ExplorerComponentTest() {
    bus_.add(sut_);
    bus_.add(navigator_);
    bus_.add(caller_);
    bus_.run_for(seconds(0.1));
  }
  void explore(bool on) {
    Explore::Request request;
    request.data(on);
    caller_.client.call(request, bus_.now() + seconds(1));
  }
  /// With a location five times a second, where the last goal was.
  void run(double s) {
    for (int i = 0; i < static_cast<int>(s * 5); ++i) {
      geometry::Pose at{0.6, 1, 0};
      if (!navigator_.goals.empty() && navigator_.arrives) at = navigator_.goals.back();
      topic::Location::Message location;
      location.pose().pose(geometry::pose_message<geometry_msgs::msg::Pose>(at));
      bus_.publish<topic::Location>(location);
      bus_.run_for(seconds(0.2));
      for (const auto& status : statuses_.take()) status_ = status.data();
    }
  }
  static std::int8_t occupancy(int column, int row, int known) {
    if (column >= known) return -1;
    return column == 0 || column == 39 || row == 0 || row == 19 ? 100 : 0;
  }
  void publish_map(int known, double yaw_rad = 0) {
    topic::Map::Message map;
    map.info().resolution(0.1F);
    map.info().width(40);
    map.info().height(20);
    map.info().origin(geometry::pose_message<geometry_msgs::msg::Pose>({0, 0, yaw_rad}));
    for (int i = 0; i < 800; ++i) map.data().push_back(occupancy(i % 40, i / 40, known));
    bus_.publish<topic::Map>(map);
  }
  void publish_tile(int from, int to) {
    topic::MapUpdates::Message tile;
    tile.x(from);
    tile.width(static_cast<std::uint32_t>(to - from));
    tile.height(20);
    for (int row = 0; row < 20; ++row) {
      for (int column = from; column < to; ++column) {
        tile.data().push_back(occupancy(column, row, 40));
      }
    }
    bus_.publish<topic::MapUpdates>(tile);
  }

  SimBus bus_;
  Context context_{bus_, "explorer", Role::uxv};
  Context navigator_context_{bus_, "navigator", Role::uxv};
  Context caller_context_{bus_, "caller", Role::uxv};
  ExplorerComponent sut_{context_, {}};
  Navigator navigator_{navigator_context_};
  Caller caller_{caller_context_};
  SimReader<topic::ExploreStatus> statuses_{bus_};
  std::string status_;
};

TEST_F(ExplorerComponentTest, DrivesToTheEndOfTheMapAsItGrowsAndEnds) {
  publish_map(20);
  run(1);
  EXPECT_EQ(status_, "idle");
  explore(true);
  run(0.4);
  EXPECT_EQ(caller_.answers, 1);
  ASSERT_EQ(navigator_.goals.size(), 1U);
  EXPECT_NEAR(navigator_.goals[0].x_m, 1.95, 1e-6);
  publish_tile(20, 30);
  run(3);
  EXPECT_NEAR(navigator_.goals.back().x_m, 2.95, 1e-6);
  publish_tile(30, 40);
  run(6);
  EXPECT_EQ(status_, "done: all that can be reached is known");
}

TEST_F(ExplorerComponentTest, CancelsItsGoalWhenItIsStopped) {
  navigator_.arrives = false;
  publish_map(20);
  explore(true);
  run(1);
  ASSERT_TRUE(navigator_.goal);
  explore(false);
  run(1);
  EXPECT_EQ(navigator_.canceled, 1);
  EXPECT_EQ(status_, "idle");
}

TEST_F(ExplorerComponentTest, ReportsARejectionAndTriesAgain) {
  navigator_.rejection = "a goal of the ground station is driven to";
  publish_map(20);
  explore(true);
  run(1);
  EXPECT_EQ(status_,
            "waiting: the navigator rejects a goal: a goal of the ground station is driven to");
  navigator_.rejection.clear();
  run(6);
  EXPECT_GE(navigator_.goals.size(), 1U);
}

TEST_F(ExplorerComponentTest, EndsWhereNothingMoreIsSeen) {
  publish_map(20);
  explore(true);
  run(60);
  EXPECT_EQ(status_.find("done: all that can be reached is known, but for"), 0U) << status_;
  EXPECT_GE(navigator_.goals.size(), 2U);
}

TEST_F(ExplorerComponentTest, IgnoresMapsThatAreTurnedOrBroken) {
  explore(true);
  publish_map(20, 0.5);
  run(2);
  EXPECT_EQ(status_, "waiting: there is no map");
  topic::Map::Message broken;
  broken.info().width(4294967295);
  broken.info().height(4294967295);
  bus_.publish<topic::Map>(broken);
  publish_tile(20, 30);
  run(2);
  EXPECT_EQ(status_, "waiting: there is no map");
}

}  // namespace
}  // namespace tocsin
