// SPDX-License-Identifier: Apache-2.0
#include "mapper/mapper_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"
#include "foundation/temporary_folder.hpp"
#include "geometry/pose_message.hpp"
#include "laser_model/laser_model.hpp"
#include "map_ports/map_input.hpp"
#include "navigation/map_loader.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

struct Caller final : Component {
  using Component::Component;
  void tick(Time now) override {
    (void)map.take();
    while (const auto outcome = save_map.take(now)) {
      map_is_saved = outcome->response && outcome->response->result();
    }
    while (const auto outcome = serialize.take(now)) {
      session_code = outcome->response ? outcome->response->result() : -1;
    }
  }
  /// Of a wall, in the map as it is now.
  [[nodiscard]] bool sees(double x_m, double y_m) const {
    return map.map() && map.map()->collides(x_m, y_m, 0.08);
  }
  MapInput map{*this};
  Client<SaveMap> save_map{*this};
  Client<SerializePoseGraph> serialize{*this};
  bool map_is_saved = false;
  int session_code = -1;
};

/// A room of 6 m x 4 m with a corner cut out, a vehicle in it on circles.
class MapperComponentTest : public ::testing::Test {
 protected:
  MapperComponentTest() {
    computer_.keeps_files = true;
    params_.start_x_m = truth_.x_m;
    params_.start_y_m = truth_.y_m;
    topic::TfStatic::Message message;
    geometry_msgs::msg::TransformStamped transform;
    transform.child_frame_id("laser");
    transform.transform().rotation().w(1);
    message.transforms().push_back(transform);
    bus_.publish<topic::TfStatic>(message);
    bus_.add(caller_);
  }
  void start() {
    sut_.reset();
    sut_ = std::make_unique<MapperComponent>(context_, params_);
    bus_.add(*sut_);
  }
  void stop() {
    bus_.remove(*sut_);
    sut_.reset();
  }
  std::string error_of_start() {
    try {
      MapperComponent refused(context_, params_);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  /// Tenths of a second.
  void drive(int steps, double way_m = 0.05) {
    for (int i = 0; i < steps; ++i) {
      truth_ = compose(truth_, {way_m, 0, way_m});
      odom_ = compose(odom_, {1.03 * way_m, 0, way_m});
      publish_odometry(odom_);
      publish_scan();
      bus_.run_for(seconds(0.1));
      for (const auto& pose : poses_.take()) pose_ = pose;
    }
  }
  void publish_odometry(const geometry::Pose& pose) {
    topic::Odom::Message message;
    message.header().stamp(stamp());
    message.pose().pose(geometry::pose_message<geometry_msgs::msg::Pose>(pose));
    bus_.publish<topic::Odom>(message);
  }
  void publish_scan() {
    topic::Scan::Message message;
    message.header().stamp(stamp());
    message.header().frame_id("laser");
    message.angle_min(static_cast<float>(-pi));
    message.angle_increment(static_cast<float>(2 * degree));
    message.range_max(12);
    const laser::Scene scene(walls_);
    for (const double range_m : laser_.turn(scene, 180, 0, [this](double) { return truth_; })) {
      message.ranges().push_back(static_cast<float>(range_m));
    }
    bus_.publish<topic::Scan>(message);
  }
  [[nodiscard]] builtin_interfaces::msg::Time stamp() const {
    return stamp_of(bus_.wall_ns(bus_.now()));
  }
  [[nodiscard]] double off_m() const {
    return distance(position(geometry::pose_in(pose_.pose().pose())), position(truth_));
  }
  [[nodiscard]] std::string path(const char* name) const { return folder_.path() + "/" + name; }

  const std::vector<geometry::Wall> walls_{{0, 0, 6, 0, 1}, {6, 0, 6, 4, 1}, {6, 4, 2, 4, 1},
                                           {2, 4, 2, 3, 1}, {2, 3, 0, 3, 1}, {0, 3, 0, 0, 1}};
  TemporaryFolder folder_;
  SimBus bus_;
  Computer computer_;
  Context context_ =
      Context{bus_, "mapper", Role::uxv}.with_computer(computer_).with_run_dir(folder_.path());
  Context caller_context_{bus_, "caller", Role::uxv};
  MapperComponent::Params params_;
  laser::LaserModel laser_{laser::find_laser_profile("rplidar_a2"), 1};
  geometry::Pose truth_{3, 0.8, 0};
  geometry::Pose odom_;
  Caller caller_{caller_context_};
  std::unique_ptr<MapperComponent> sut_;
  SimReader<topic::AmclPose> poses_{bus_};
  SimReader<topic::Tf> transforms_{bus_};
  SimReader<topic::Map> maps_{bus_};
  SimReader<topic::MapTiles> tiles_{bus_};
  topic::AmclPose::Message pose_;
};

TEST_F(MapperComponentTest, MapsTheRoomThatItDrivesIn) {
  start();
  drive(150);
  EXPECT_LT(off_m(), 0.06) << "the odometry is 0.2 m off";
  EXPECT_LT(std::sqrt(pose_.pose().covariance()[0]), 0.05);
  EXPECT_EQ(maps_.take().back().header().frame_id(), "map");
  for (const auto& wall : {geometry::Point{3, 0}, {6, 2}, {4, 4}, {2, 3.5}, {1, 3}, {0, 1.5}}) {
    EXPECT_TRUE(caller_.sees(wall.x_m, wall.y_m)) << wall.x_m << ", " << wall.y_m;
  }
  EXPECT_FALSE(caller_.sees(3, 2));
  const auto transform = transforms_.take().back().transforms()[0];
  EXPECT_EQ(transform.header().frame_id(), "map");
  EXPECT_EQ(transform.child_frame_id(), "odom");
}

TEST_F(MapperComponentTest, SendsEachTileThatChangesAndAllOfThemAgain) {
  start();
  drive(100);
  (void)tiles_.take();
  bus_.run_for(seconds(30));
  const auto tiles = tiles_.take();
  ASSERT_GT(tiles.size(), 20U) << "one a second";
  std::set<std::pair<int, int>> indices;
  for (const auto& tile : tiles) {
    EXPECT_EQ(tile.side(), 64);
    EXPECT_TRUE(navigation::unpacked_tile(tile.cells()));
    EXPECT_EQ(tile.session(), tiles[0].session());
    indices.emplace(tile.column(), tile.row());
  }
  EXPECT_GE(indices.size(), 4U);
}

TEST_F(MapperComponentTest, AddsNothingWhileItStands) {
  start();
  drive(20);
  drive(60, 0);
  (void)maps_.take();
  drive(100, 0);
  ASSERT_LT(off_m(), 0.06);
  EXPECT_TRUE(maps_.take().empty());
}

TEST_F(MapperComponentTest, GoesOnWhereOdometryBeginsAnew) {
  start();
  drive(40);
  odom_ = {-7, 2, 1};
  drive(40);
  EXPECT_LT(off_m(), 0.06);
}

TEST_F(MapperComponentTest, PassesOverOdometryThatIsNotFinite) {
  start();
  drive(20);
  publish_odometry({nan, 0, 0});
  publish_odometry({0, infinity, 0});
  drive(20);
  EXPECT_LT(off_m(), 0.06);
}

TEST_F(MapperComponentTest, SaysThatItIsNotSureWhereNothingMatches) {
  start();
  drive(20);
  for (int i = 0; i < 100; ++i) {
    odom_ = compose(odom_, {0.05, 0, 0});
    publish_odometry(odom_);
    topic::Scan::Message dark;
    dark.header().stamp(stamp());
    dark.header().frame_id("laser");
    dark.angle_increment(0.1F);
    dark.range_max(12);
    dark.ranges(std::vector<float>(60, std::numeric_limits<float>::infinity()));
    bus_.publish<topic::Scan>(dark);
    bus_.run_for(seconds(0.1));
  }
  EXPECT_GT(std::sqrt(poses_.take().back().pose().covariance()[0]), 0.2);
}

TEST_F(MapperComponentTest, GrowsNoMoreWhenItIsFull) {
  params_.most_scans = 15;
  start();
  drive(30);
  SimReader<topic::Diagnostics> diagnostics(bus_);
  drive(100);
  EXPECT_LT(off_m(), 0.06) << "it still knows where it is";
  const auto status = diagnostics.take().back().status()[0];
  EXPECT_EQ(status.message(), "the map is full");
  EXPECT_EQ(status.values()[0].value(), "15");
}

TEST_F(MapperComponentTest, SavesWhatIsAskedFor) {
  start();
  nav2_msgs::srv::SaveMap_Request map;
  map.map_url(path("room"));
  slam_toolbox::srv::SerializePoseGraph_Request session;
  session.filename(path("room"));
  (void)caller_.serialize.call(session, bus_.now() + seconds(1));
  bus_.run_for(seconds(1));
  EXPECT_EQ(caller_.session_code, 255) << "there is no map yet";
  drive(60);
  (void)caller_.save_map.call(map, bus_.now() + seconds(1));
  (void)caller_.serialize.call(session, bus_.now() + seconds(1));
  bus_.run_for(seconds(1));
  EXPECT_TRUE(caller_.map_is_saved);
  EXPECT_EQ(caller_.session_code, 0);
  const auto saved = navigation::load_map(path("room.yaml"));
  EXPECT_TRUE(saved.collides(6, 2, 0.1));
  EXPECT_TRUE(std::filesystem::exists(path("room.session")));

  map.map_url("/nowhere/room");
  (void)caller_.save_map.call(map, bus_.now() + seconds(1));
  map.map_url("");
  (void)caller_.save_map.call(map, bus_.now() + seconds(1));
  bus_.run_for(seconds(1));
  EXPECT_FALSE(caller_.map_is_saved);
}

TEST_F(MapperComponentTest, SavesItsMapAtTheEndAndGoesOnWithIt) {
  params_.map_name = path("room");
  params_.save_every_s = 1000;
  start();
  drive(60);
  EXPECT_FALSE(std::filesystem::exists(path("room.session")));
  stop();
  EXPECT_TRUE(std::filesystem::exists(path("room.yaml")));

  // In another launch, whose odometry begins anew.
  std::filesystem::remove(context_.state_path(".map"));
  params_.session_file = path("room.session");
  params_.start_x_m = truth_.x_m + 0.3;  // about there
  params_.start_y_m = truth_.y_m - 0.3;
  params_.start_yaw_rad = truth_.heading_rad;
  odom_ = {};
  start();
  drive(60);
  EXPECT_LT(off_m(), 0.06);
  EXPECT_TRUE(caller_.sees(0, 1.5));
}

TEST_F(MapperComponentTest, GoesOnAfterARestartWithinItsLaunch) {
  params_.map_name = path("room");
  params_.save_every_s = 2;
  start();
  drive(60);
  bus_.remove(*sut_);
  std::filesystem::copy(path("room.session"), path("kept.session"));
  sut_.reset();  // a process that is killed does not save
  std::filesystem::rename(path("kept.session"), path("room.session"));
  start();
  drive(60);
  EXPECT_LT(off_m(), 0.06);
  EXPECT_TRUE(caller_.sees(0, 1.5));
}

TEST_F(MapperComponentTest, WritesOverNoMapThatItDoesNotGoOnWith) {
  params_.map_name = path("room");
  std::ofstream(path("room.yaml")) << "image: room.pgm\n";
  EXPECT_THAT(error_of_start(), HasSubstr("room.yaml is there already"));
  params_.map_name = "";
  params_.session_file = path("none.session");
  EXPECT_THAT(error_of_start(), HasSubstr("none.session"));
  std::ofstream(path("bad.session")) << "image: room.pgm\n";
  params_.session_file = path("bad.session");
  EXPECT_THAT(error_of_start(), HasSubstr("is no session of a map"));
}

}  // namespace
}  // namespace tocsin
