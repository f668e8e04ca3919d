// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus.hpp"

#include "runtime/host_control.hpp"
#include "runtime/middleware/host_graph.hpp"

namespace tocsin {

const std::string& HostControl::ros_namespace() const {
  static const std::string none;
  return none;
}

std::unique_ptr<HostGraph> HostControl::open_graph() const { return nullptr; }

HostControl& Bus::host_control() {
  static HostControl none;
  return none;
}

}  // namespace tocsin
