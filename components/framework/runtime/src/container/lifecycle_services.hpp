// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "container/instances.hpp"
#include "container/ros_lifecycle.hpp"
#include "runtime/middleware/ros_services.hpp"
#include "runtime/service_port.hpp"

namespace tocsin {

/// The lifecycle of one node, for who asks from outside.
struct LifecycleSource {
  std::function<LifecycleState()> state;
  std::function<Outcome(Transition)> change;
};

/// Serves the lifecycle of one node, and tells its changes on `~/transition_event`. One thread,
/// that of its owner.
class LifecycleServices {
 public:
  /// `state`: that the node has now.
  LifecycleServices(Component& owner, const std::string& node, LifecycleState state);
  /// Answers all that has come, and tells what has changed since.
  void answer(const LifecycleSource& source);

 private:
  void answer_readers(LifecycleState state);
  void tell(LifecycleState state);
  Component& owner_;
  LifecycleState told_;
  Server<lifecycle_service::ChangeState> change_;
  Server<lifecycle_service::GetState> state_;
  Server<lifecycle_service::GetAvailableStates> states_;
  Server<lifecycle_service::GetAvailableTransitions> transitions_;
  Server<lifecycle_service::GetTransitionGraph> graph_;
  std::unique_ptr<Publication> events_;
};

}  // namespace tocsin
