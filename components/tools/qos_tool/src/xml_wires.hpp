// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dialect.hpp"
#include "lint.hpp"

namespace tocsin::qos_tool {

/// What the participants of a file of Fast DDS or Cyclone DDS do on the network; when it has none,
/// what a participant with the library's defaults does.
[[nodiscard]] std::vector<Wire> wires_of(Vendor vendor, const tinyxml2::XMLElement& root);

}  // namespace tocsin::qos_tool
