// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "runtime/bus.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Hears what the containers of a host say of themselves: the other end of ControlComponent. What
/// is asked of them goes by the services of composition_service.hpp and lifecycle_service.hpp.
/// Waits in real time, so it is for programs of the user, not for components.
class ContainerStates : private Receiver {
 public:
  using State = tocsin_msgs::msg::ContainerState;
  /// By container name and process id.
  using Known = std::map<std::pair<std::string, int>, State>;

  explicit ContainerStates(Bus& bus);

  /// What is known when `enough` says so, or after `patience`.
  Known wait(Duration patience, const std::function<bool(const Known&)>& enough);

 private:
  void receive(const Sample& sample) override;
  std::mutex mutex_;
  std::condition_variable heard_;
  Known known_;
  std::unique_ptr<Subscription> states_;
};

/// Name of the node of a container, which has its services.
[[nodiscard]] inline std::string container_node(const std::string& container) {
  return container + "_container";
}

/// "host/container" of all that were heard, each once. Names of users are looked up among them
/// (foundation/names.hpp).
[[nodiscard]] std::vector<std::string> container_paths(const ContainerStates::Known& known);

}  // namespace tocsin
