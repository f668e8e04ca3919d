// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/container_states.hpp"

#include <set>

namespace tocsin {
ContainerStates::ContainerStates(Bus& bus)
    : states_(bus.subscribe(
          {topic::ContainerState::info, &type_info<topic::ContainerState::Message>()}, *this)) {}

void ContainerStates::receive(const Sample& sample) {
  const auto state = std::static_pointer_cast<const State>(sample.message);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    known_[{state->container(), state->pid()}] = *state;
  }
  heard_.notify_all();
}

ContainerStates::Known ContainerStates::wait(Duration patience,
                                             const std::function<bool(const Known&)>& enough) {
  std::unique_lock<std::mutex> lock(mutex_);
  (void)heard_.wait_for(lock, patience, [&] { return enough(known_); });
  return known_;
}

std::vector<std::string> container_paths(const ContainerStates::Known& known) {
  std::set<std::string> paths;
  for (const auto& one : known) paths.insert(one.second.host() + "/" + one.second.container());
  return {paths.begin(), paths.end()};
}

}  // namespace tocsin
