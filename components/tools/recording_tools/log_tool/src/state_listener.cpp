// SPDX-License-Identifier: Apache-2.0
#include "state_listener.hpp"

#include "idl_support/decode.hpp"

namespace tocsin::log_tool {

StateListener::StateListener(HostGraph& graph, const std::string& ros_namespace)
    : prefix_(ros_namespace.empty() ? "" : ros_namespace + "/"),
      reading_(graph.read(
          {on_wire(topic::LinkState::info.name), type_info<State>().name},
          [this](RawSample&& sample) {
            const auto message = decode(type_info<State>(), *sample.bytes);
            if (!message) return;
            const std::lock_guard<std::mutex> lock(mutex_);
            heard_.push_back({*std::static_pointer_cast<State>(message), sample.received});
          })) {}

std::vector<StateListener::Heard> StateListener::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(heard_, {});
}

}  // namespace tocsin::log_tool
