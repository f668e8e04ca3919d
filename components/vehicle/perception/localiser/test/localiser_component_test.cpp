// SPDX-License-Identifier: Apache-2.0
#include "localiser/localiser_component.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"
#include "geometry/pose_message.hpp"
#include "laser_model/laser_model.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

struct Caller final : Component {
  using Component::Component;
  void tick(Time) override {}
  Client<ReinitializeGlobalLocalization> reinitialize{*this};
  Client<SetInitialPose> set_initial_pose{*this};
  Client<RequestNomotionUpdate> nomotion{*this};
};

/// A room of 6 m x 4 m with a corner cut out, a vehicle in it on circles.
class LocaliserComponentTest : public ::testing::Test {
 protected:
  LocaliserComponentTest() {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "m.yaml") << "image: m.pgm\nresolution: 0.05\norigin: [-1, -1, 0]\n";
    std::string cells(160 * 120, '\xfe');
    for (const geometry::Wall& wall : walls_) {
      for (int i = 0; i <= 600; ++i) {
        const geometry::Point at =
            geometry::between({wall.x1_m, wall.y1_m}, {wall.x2_m, wall.y2_m}, i / 600.0);
        const int column = static_cast<int>((at.x_m + 1) / 0.05);
        const int row = 119 - static_cast<int>((at.y_m + 1) / 0.05);
        cells[static_cast<std::size_t>(row * 160 + column)] = '\0';
      }
    }
    std::ofstream(folder_ / "m.pgm") << "P5 160 120 255\n" << cells;
    params_.map_file = (folder_ / "m.yaml").string();
    params_.start_x_m = truth_.x_m;
    params_.start_y_m = truth_.y_m;
    topic::TfStatic::Message message;
    geometry_msgs::msg::TransformStamped transform;
    transform.child_frame_id("laser");
    transform.transform().rotation().w(1);
    message.transforms().push_back(transform);
    bus_.publish<topic::TfStatic>(message);
  }
  ~LocaliserComponentTest() override { std::filesystem::remove_all(folder_); }

  void start() {
    sut_ = std::make_unique<LocaliserComponent>(context_, params_);
    bus_.add(*sut_);
  }
  /// Tenths of a second.
  void drive(int steps, double way_m = 0.05) {
    for (int i = 0; i < steps; ++i) {
      truth_ = compose(truth_, {way_m, 0, way_m});
      odom_ = compose(odom_, {1.03 * way_m, 0, way_m});
      publish_odometry();
      publish_scan();
      bus_.run_for(seconds(0.1));
      for (const auto& pose : poses_.take()) pose_ = pose;
    }
  }
  void publish_odometry() {
    topic::Odom::Message message;
    message.header().stamp(stamp());
    message.pose().pose(geometry::pose_message<geometry_msgs::msg::Pose>(odom_));
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
  void say_where(const geometry::Pose& pose, const char* frame = "map") {
    topic::InitialPose::Message message;
    message.header().frame_id(frame);
    message.pose().pose(geometry::pose_message<geometry_msgs::msg::Pose>(pose));
    bus_.publish<topic::InitialPose>(message);
  }
  [[nodiscard]] builtin_interfaces::msg::Time stamp() const {
    const std::int64_t ns = bus_.wall_ns(bus_.now());
    builtin_interfaces::msg::Time stamp;
    stamp.sec(static_cast<std::int32_t>(ns / 1'000'000'000));
    stamp.nanosec(static_cast<std::uint32_t>(ns % 1'000'000'000));
    return stamp;
  }
  [[nodiscard]] double off_m() const {
    return distance(position(geometry::pose_in(pose_.pose().pose())), position(truth_));
  }
  [[nodiscard]] double deviation_m() const { return std::sqrt(pose_.pose().covariance()[0]); }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("tocsin_localiser_" + std::to_string(::getpid()));
  const std::vector<geometry::Wall> walls_{{0, 0, 6, 0, 1}, {6, 0, 6, 4, 1}, {6, 4, 2, 4, 1},
                                           {2, 4, 2, 3, 1}, {2, 3, 0, 3, 1}, {0, 3, 0, 0, 1}};
  SimBus bus_;
  Context context_{bus_, "localiser", Role::uxv};
  LocaliserComponent::Params params_;
  laser::LaserModel laser_{laser::find_laser_profile("rplidar_a2"), 1};
  geometry::Pose truth_{3, 0.8, 0};
  geometry::Pose odom_;
  std::unique_ptr<LocaliserComponent> sut_;
  SimReader<topic::AmclPose> poses_{bus_};
  SimReader<topic::Tf> transforms_{bus_};
  SimReader<topic::ParticleCloud> clouds_{bus_};
  topic::AmclPose::Message pose_;
};

TEST_F(LocaliserComponentTest, TellsPoseTransformAndHypotheses) {
  start();
  drive(60);
  EXPECT_LT(off_m(), 0.05);
  EXPECT_LT(deviation_m(), 0.1);
  EXPECT_GT(deviation_m(), 0.001);
  EXPECT_EQ(pose_.header().frame_id(), "map");
  const auto transforms = transforms_.take();
  ASSERT_FALSE(transforms.empty());
  const auto& last = transforms.back().transforms().at(0);
  EXPECT_EQ(last.header().frame_id(), "map");
  EXPECT_EQ(last.child_frame_id(), "odom");
  const geometry::Pose map_from_odom{last.transform().translation().x(),
                                     last.transform().translation().y(),
                                     geometry::heading_in(last.transform().rotation())};
  EXPECT_LT(distance(position(compose(map_from_odom, odom_)), position(truth_)), 0.05);
  const auto clouds = clouds_.take();
  EXPECT_NEAR(static_cast<double>(clouds.size()), 6, 1) << "one a second";
  EXPECT_FALSE(clouds.back().particles().empty());
}

TEST_F(LocaliserComponentTest, BelievesAPersonWhoSaysWhereItIs) {
  params_.start_x_m = 5;
  params_.start_y_m = 3.5;
  start();
  say_where({truth_.x_m + 0.2, truth_.y_m - 0.1, 0.1});
  drive(40);
  EXPECT_LT(off_m(), 0.05);
  say_where({nan, 0, 0});
  say_where({1, 1, 0}, "odom");
  drive(10);
  EXPECT_LT(off_m(), 0.05) << "refused";
}

TEST_F(LocaliserComponentTest, IsToldWhereItIsByNav2sService) {
  params_.start_x_m = 1;
  params_.start_y_m = 2;
  start();
  Caller caller(context_);
  bus_.add(caller);
  drive(5, 0);
  ASSERT_GT(off_m(), 0.5);
  SetInitialPose::Request request;
  request.pose().header().frame_id("map");
  request.pose().pose().pose(geometry::pose_message<geometry_msgs::msg::Pose>(truth_));
  caller.set_initial_pose.call(std::move(request), bus_.now() + seconds(1));
  drive(5, 0);
  EXPECT_LT(off_m(), 0.05);
  caller.nomotion.call({}, bus_.now() + seconds(1));
  drive(2, 0);
  const auto told = caller.set_initial_pose.take(bus_.now());
  const auto counted = caller.nomotion.take(bus_.now());
  ASSERT_TRUE(told && counted);
  EXPECT_TRUE(told->response && counted->response);
}

TEST_F(LocaliserComponentTest, LooksEverywhereWhenAsked) {
  params_.start_anywhere = true;
  start();
  drive(1);
  EXPECT_GE(deviation_m(), 1);
  drive(100);
  EXPECT_LT(off_m(), 0.05);
  Context context{bus_, "caller", Role::uxv};
  Caller caller{context};
  bus_.add(caller);
  truth_ = {1, 1.5, 2};
  drive(1);
  caller.reinitialize.call({}, bus_.now() + seconds(1));
  drive(100);
  EXPECT_LT(off_m(), 0.05);
  bus_.remove(caller);
}

TEST_F(LocaliserComponentTest, SaysNothingWithoutOdometry) {
  start();
  for (int i = 0; i < 20; ++i) {
    publish_scan();
    bus_.run_for(seconds(0.1));
  }
  EXPECT_TRUE(poses_.take().empty());
}

TEST_F(LocaliserComponentTest, KnowsWhereItIsAfterARestart) {
  context_.run_dir = folder_.string();
  start();
  drive(60);
  bus_.remove(*sut_);
  sut_.reset();
  start();
  drive(1);
  EXPECT_LT(off_m(), 0.1);
}

TEST_F(LocaliserComponentTest, RefusesToStartWithoutAMap) {
  params_.map_file.clear();
  EXPECT_THROW(start(), ConfigError);
  params_.map_file = "/nowhere.yaml";
  EXPECT_THROW(start(), ConfigError);
  std::ofstream(folder_ / "m.pgm") << "P5 160 120 255\n" << std::string(160 * 120, '\0');
  params_.map_file = (folder_ / "m.yaml").string();
  EXPECT_THROW(start(), ConfigError) << "walls only";
}

}  // namespace
}  // namespace tocsin
