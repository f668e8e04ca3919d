// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>

#include "foundation/error.hpp"
#include "mission_control/mission_control_component.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {

/// A mission control with a mission of two waypoints, and the topics of a vehicle.
class MissionControlComponentTest : public ::testing::Test {
 protected:
  MissionControlComponentTest() {
    std::filesystem::create_directories(folder_);
    params_.mission_file =
        write("two.yaml", "name: two\nwaypoints: [{x: 1, y: 0.5}, {x: 3, y: 0.5}]\n");
    context_.request_exit = [this](int code) { exit_code_ = code; };
  }
  ~MissionControlComponentTest() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  /// A floor of 4 m x 1 m whose left half is a wall, or free.
  std::string write_map(bool has_wall) const {
    write("m.pgm", "P2 2 1 1\n" + std::string(has_wall ? "0" : "1") + " 1\n");
    return write("m.yaml", "image: m.pgm\nresolution: 2\norigin: [0, 0, 0]\n");
  }
  void start() {
    sut_ = std::make_unique<MissionControlComponent>(context_, params_);
    bus_.add(*sut_);
  }
  std::string error_of_start() {
    try {
      start();
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  void locate(double x) {
    topic::Location::Message message;
    message.pose().pose().position().x(x);
    message.pose().pose().position().y(0.5);
    message.pose().pose().orientation().w(1);
    bus_.publish<topic::Location>(message);
  }
  void tell(const topic::Goal::Message& goal, const char* state) {
    topic::NavigationStatus::Message message;
    message.goal_id(goal.id());
    message.mission(goal.mission());
    message.state(state);
    bus_.publish<topic::NavigationStatus>(message);
  }
  void say(const char* words) {
    topic::MissionCommand::Message message;
    message.data(words);
    bus_.publish<topic::MissionCommand>(message);
    run(0.05);  // the next words would take their place
  }
  void run(double s) { bus_.run_for(seconds(s)); }
  topic::Goal::Message first_goal() {
    start();
    run(0.1);
    locate(0);
    run(2.5);
    return goals_.take().at(0);
  }
  std::string state() {
    const auto statuses = statuses_.take();
    return statuses.empty() ? "none" : statuses.back().state();
  }

  const std::filesystem::path folder_ = std::filesystem::temp_directory_path() /
                                        ("tocsin_mission_control_" + std::to_string(::getpid()));
  SimBus bus_;
  Context context_{bus_, "mission_control", Role::gcs};
  MissionControlComponent::Params params_;
  std::unique_ptr<MissionControlComponent> sut_;
  SimReader<topic::Goal> goals_{bus_};
  SimReader<topic::MissionStatus> statuses_{bus_};
  SimReader<topic::MissionPath> paths_{bus_};
  std::optional<int> exit_code_;
};

}  // namespace tocsin
