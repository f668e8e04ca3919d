// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "advice.hpp"

namespace tocsin::doctor {

/// A network interface with an IPv4 address.
struct Interface {
  std::string name;
  std::string address;
  bool up = false;
  bool carrier = false;  ///< Fast DDS ignores an interface without it at start
};

/// Those of this computer (of the current network namespace).
[[nodiscard]] std::vector<Interface> interfaces();

/// Whether `wanted`, the address of a host in a bringup file, can be used here. An absent one is
/// no fault: it may be the other side's, or of a namespace that the launch makes.
[[nodiscard]] Advice judge_address(const std::string& wanted,
                                   const std::vector<Interface>& interfaces);

/// Whether loopback, which all host topics use, is up.
[[nodiscard]] Advice judge_loopback(const std::vector<Interface>& interfaces);

}  // namespace tocsin::doctor
