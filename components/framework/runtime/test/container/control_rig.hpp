// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <memory>
#include <optional>
#include <string>

#include "container/control_component.hpp"
#include "container/node_asker.hpp"

namespace tocsin {

/// A container on a bus in memory: its instances, and the control that answers for them.
class ControlRig : public ::testing::Test {
 protected:
  using Mode = deployment::ParameterServices;
  using Entries = const ComponentEntry& (*)(const std::string& library);
  /// `node`: of the control; empty: its name, "control".
  explicit ControlRig(Entries entries, const std::string& node = "drive_container")
      : context_(Context(bus_, "control", Role::uxv).with_node(node)),
        instances_(context_, ticker_, entries) {}
  void add(const std::string& library, const std::string& name, const std::string& yaml = "{}") {
    instances_.add(library, name, std::make_shared<const YAML::Node>(YAML::Load(yaml)), {});
  }
  void start(Mode mode = Mode::on_demand) {
    control_.emplace(
        context_, HealthLimits{}, ProcessName{"uxv", "drive", 7, mode}, instances_,
        ControlComponent::Computer{[] { return 0; }, [](auto&) { return std::nullopt; }});
    bus_.add(*control_);
  }

  SimBus bus_;
  Context context_;
  SimTicker ticker_{bus_};
  Instances instances_;
  std::optional<ControlComponent> control_;
};

}  // namespace tocsin
