// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "container/composition_services.hpp"
#include "container/instances.hpp"
#include "container/node_services.hpp"
#include "container/rosout.hpp"
#include "deployment/deployment.hpp"
#include "runtime/host_control.hpp"
#include "runtime/port.hpp"

namespace tocsin {

/// Where ROS 2 hears of parameters that have changed, whatever the namespace.
struct ParameterEvents {
  using Message = rcl_interfaces::msg::ParameterEvent;
  static constexpr TopicInfo info{"/parameter_events", "event", Scope::host};
};

/// What ROS 2 asks of the nodes of a container and of the container itself, and what it hears of
/// them: services, parameter events, transition events, the log. One thread, that of its owner.
class ServedNodes {
 public:
  /// Which nodes have services. Many ends of DDS for each node: on demand they are made for who
  /// asks, and taken away a while after he has gone.
  using Mode = deployment::ParameterServices;
  /// `owner`: the container's own node. `instances` must outlive it.
  ServedNodes(Component& owner, Instances& instances, Mode mode);
  /// Answers all that has come. True when ends or instances have come or gone.
  bool serve(const CompositionServices::Load& load, Time now);
  /// Tells what was logged.
  void tell_log();

 private:
  /// Of a node that somebody asks, or has asked not long ago.
  struct Served {
    Time asked;
    std::unique_ptr<NodeServices> services;
    std::unique_ptr<Publication> events;  ///< of its parameters
  };
  struct ServedContainer {
    Time asked;
    std::unique_ptr<ContainerServices> services;
  };
  [[nodiscard]] bool is_asked(bool called, const Callers& callers) const;
  void note_callers(Time now);
  [[nodiscard]] bool has_logger(const std::string& name) const;
  bool serve_container(const CompositionServices::Load& load);
  [[nodiscard]] ParameterSource parameters_of(const Instance& instance, Time now);
  [[nodiscard]] LifecycleSource lifecycle_of(const Instance& instance);
  void tell_change(const Instance& instance,
                   const std::vector<rcl_interfaces::msg::Parameter>& changed, Time now);
  Component& owner_;
  Instances& instances_;
  const Mode mode_;
  Logger log_;
  std::map<std::uint32_t, Served> served_;
  ServedContainer container_;
  bool changed_ = false;         ///< the state of an instance, by somebody who asked
  std::set<std::string> nodes_;  ///< that have /rosout
  Rosout rosout_;
};

}  // namespace tocsin
