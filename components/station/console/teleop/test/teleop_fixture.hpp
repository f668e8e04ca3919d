// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "devices/computer.hpp"
#include "runtime/sim_bus.hpp"
#include "teleop/teleop_component.hpp"

namespace tocsin {

using Speeds = std::vector<double>;

/// A component by which a person drives, ticked as the runner would.
template <class Component>
class TeleopFixture : public ::testing::Test {
 protected:
  TeleopFixture(const char* name, const Computer& computer)
      : context_(Context(bus_, name, Role::gcs).with_computer(computer)),
        sut_(std::make_unique<Component>(context_, typename Component::Params{})) {}

  /// The speeds that were sent within `s`.
  Speeds run(double s) {
    const Time end = bus_.now() + seconds(s);
    for (Time next = bus_.now(); next <= end;) {
      bus_.run_until(next);
      sut_->schedule().begin_tick(next);
      sut_->tick(next);
      next = sut_->schedule().due();
    }
    bus_.run_until(end);
    return sent();
  }
  Speeds sent() {
    Speeds speeds;
    for (const auto& command : commands_.take()) speeds.push_back(command.twist().linear().x());
    return speeds;
  }
  void report_driver(const std::string& name, const std::string& asked_by = "") {
    topic::DriverState::Message state;
    state.driver(name);
    state.asked_by(asked_by);
    bus_.publish<topic::DriverState>(state);
    run(0);
  }
  /// Verbs that were sent in the operator's name.
  std::vector<std::string> requests(const std::string& name) {
    std::vector<std::string> verbs;
    for (const auto& request : requests_.take()) {
      EXPECT_EQ(request.name(), name);
      verbs.push_back(request.verb());
    }
    return verbs;
  }

  SimBus bus_;
  Context context_;
  SimReader<topic::TeleopCmdVel> commands_{bus_};
  SimReader<topic::DriverRequest> requests_{bus_};
  std::unique_ptr<Component> sut_;
};

}  // namespace tocsin
