// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "foundation/ros_names.hpp"
#include "runtime/middleware/host_graph.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::log_tool {

/// Hears the routers' states on a host's domain, in one namespace.
class StateListener {
 public:
  using State = tocsin_msgs::msg::LinkState;
  struct Heard {
    State state;
    Time at{};
  };
  /// `ros_namespace` without slashes; empty for none.
  explicit StateListener(HostGraph& graph, const std::string& ros_namespace = "");
  /// Of a topic of these routers.
  [[nodiscard]] std::string on_wire(const std::string& topic) const {
    return wire_topic(prefix_ + topic);
  }
  /// Those that came since the last call.
  [[nodiscard]] std::vector<Heard> take();

 private:
  const std::string prefix_;
  std::mutex mutex_;
  std::vector<Heard> heard_;
  std::unique_ptr<RawReading> reading_;  ///< last: it uses the others
};

}  // namespace tocsin::log_tool
