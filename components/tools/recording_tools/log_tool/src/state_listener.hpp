// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "runtime/middleware/host_graph.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::log_tool {

/// Hears the routers' states on a host's domain.
class StateListener {
 public:
  using State = tocsin_msgs::msg::LinkState;
  struct Heard {
    State state;
    Time at{};
  };
  explicit StateListener(HostGraph& graph);
  /// Those that came since the last call.
  [[nodiscard]] std::vector<Heard> take();

 private:
  std::mutex mutex_;
  std::vector<Heard> heard_;
  std::unique_ptr<RawReading> reading_;  ///< last: it uses the others
};

}  // namespace tocsin::log_tool
