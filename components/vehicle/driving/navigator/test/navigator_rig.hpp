// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "foundation/error.hpp"
#include "geometry/pose.hpp"
#include "navigator/navigator_component.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {

/// A navigator on a bare floor of 10 m x 10 m around (0, 0), and a base that drives as told.
class NavigatorComponentTest : public ::testing::Test {
 protected:
  NavigatorComponentTest() {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "m.yaml") << "image: m.pgm\nresolution: 0.1\norigin: [-5, -5, 0]\n";
    std::ofstream(folder_ / "m.pgm") << "P5 100 100 255\n" << std::string(10000, '\xfe');
    params_.map_file = (folder_ / "m.yaml").string();
    params_.start_x_m = -1;
    start();
  }
  ~NavigatorComponentTest() override { std::filesystem::remove_all(folder_); }

  void start() { sut_ = std::make_unique<NavigatorComponent>(context_, params_); }

  /// Runs with odometry at 20 Hz.
  void run(double s) {
    for (int i = 0; i < std::lround(s * 20); ++i) {
      if (has_odometry_) bus_.publish<topic::Odom>(odometry());
      sut_->tick(bus_.now());
      bus_.run_for(seconds(0.05));
      for (const auto& command : commands_.take()) command_ = command;
      odom_ = compose(odom_, {command_.linear().x() * 0.05, 0, command_.angular().z() * 0.05});
      for (const auto& status : statuses_.take()) status_ = status;
    }
  }
  topic::Odom::Message odometry() const {
    topic::Odom::Message message;
    message.pose().pose().position().x(odom_.x_m);
    message.pose().pose().position().y(odom_.y_m);
    message.pose().pose().orientation().z(std::sin(odom_.heading_rad / 2));
    message.pose().pose().orientation().w(std::cos(odom_.heading_rad / 2));
    return message;
  }
  void send_goal(std::uint64_t id, double x, double age_s = 0, double lifetime_s = 60) {
    const std::int64_t stamp_ns = bus_.wall_ns(bus_.now()) - static_cast<std::int64_t>(age_s * 1e9);
    topic::Goal::Message goal = goal_;
    goal.stamp().sec(static_cast<std::int32_t>(stamp_ns / 1'000'000'000));
    goal.stamp().nanosec(static_cast<std::uint32_t>(stamp_ns % 1'000'000'000));
    goal.id(id);
    goal.x(x);
    goal.tolerance_m(0.15);
    goal.lifetime_s(lifetime_s);
    bus_.publish<topic::Goal>(goal);
  }
  void press_emergency_stop(bool is_pressed) {
    topic::EmergencyStop::Message message;
    message.data(is_pressed);
    bus_.publish<topic::EmergencyStop>(message);
  }
  void hear_link(bool stands) {
    topic::LinkStop::Message message;
    message.stands(stands);
    bus_.publish<topic::LinkStop>(message);
  }
  void send_heartbeat(const char* role) {
    topic::Heartbeat::Message message;
    message.role(role);
    bus_.publish<topic::Heartbeat>(message);
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("tocsin_navigator_" + std::to_string(::getpid()));
  SimBus bus_;
  Context context_{bus_, "navigator", Role::uxv};
  NavigatorComponent::Params params_;
  std::unique_ptr<NavigatorComponent> sut_;
  SimReader<topic::CmdVelNavigation> commands_{bus_};
  SimReader<topic::Location> locations_{bus_};
  SimReader<topic::NavigationStatus> statuses_{bus_};
  geometry::Pose odom_;
  bool has_odometry_ = true;
  topic::CmdVelNavigation::Message command_;
  topic::Goal::Message goal_;  // what is sent but for what is told
  topic::NavigationStatus::Message status_;
};

}  // namespace tocsin
