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

/// Hears the containers of a host and sends them commands: the other end of ControlComponent.
/// Waits in real time, so it is for programs of the user, not for components.
class ContainerClient : private Receiver {
 public:
  using State = tocsin_msgs::msg::ContainerState;
  using Command = tocsin_msgs::msg::ContainerCommand;
  using Answer = tocsin_msgs::msg::ContainerAnswer;
  /// By container name and process id.
  using Known = std::map<std::pair<std::string, int>, State>;

  explicit ContainerClient(Bus& bus);

  /// What is known when `enough` says so, or after `patience`.
  Known wait(Duration patience, const std::function<bool(const Known&)>& enough);
  /// Sends the command under a new id until it is answered. Throws EnvironmentError when no answer
  /// came within `patience`.
  Answer ask(Command command, Duration patience);

 private:
  void receive(const Sample& sample) override;
  std::mutex mutex_;
  std::condition_variable heard_;
  Known known_;
  std::unique_ptr<Publication> commands_;
  std::unique_ptr<Subscription> states_;
};

/// "host/container" of all that were heard, and "host/container/instance" of all that they run;
/// each once. Names of users are looked up among them (foundation/names.hpp).
[[nodiscard]] std::vector<std::string> container_paths(const ContainerClient::Known& known);
[[nodiscard]] std::vector<std::string> instance_paths(const ContainerClient::Known& known);

}  // namespace tocsin
