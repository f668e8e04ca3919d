// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "container/instances.hpp"
#include "runtime/middleware/ros_services.hpp"
#include "runtime/service_port.hpp"

namespace tocsin {

/// What `load_node` asks for, in our words.
struct LoadOrder {
  std::string library;
  std::string name;
  std::string parameters;  ///< a YAML map
};
/// Why it cannot be done, as a text; else the order. `ros_namespace`: of the run. Pure.
struct LoadReading {
  std::optional<LoadOrder> order;
  std::string fault;
};
[[nodiscard]] LoadReading read_load(const composition_service::LoadNode::Request& request,
                                    const std::string& ros_namespace);

/// Puts components into this process, takes them out and changes the QoS of its topics, for who
/// asks from outside. One thread, that of its owner.
class CompositionServices {
 public:
  using Load = std::function<Outcome(const LoadOrder& order)>;
  /// The services are those of the owner's node. `instances` must outlive it.
  CompositionServices(Component& owner, Instances& instances);
  /// Answers all that has come. True when that has changed what the process has.
  bool answer(const Load& load);

 private:
  bool answer_load(const Load& load);
  bool answer_unload();
  void answer_list();
  bool answer_set_qos();
  [[nodiscard]] composition_service::LoadNode::Response loaded(
      const composition_service::LoadNode::Request& request, const Load& load) const;
  [[nodiscard]] const Instance* find(const std::string& name) const;
  [[nodiscard]] std::string path_of(const std::string& name) const;
  Component& owner_;
  Instances& instances_;
  Server<composition_service::LoadNode> load_;
  Server<composition_service::UnloadNode> unload_;
  Server<composition_service::ListNodes> list_;
  Server<composition_service::SetQos> set_qos_;
  Logger log_;
};

}  // namespace tocsin
