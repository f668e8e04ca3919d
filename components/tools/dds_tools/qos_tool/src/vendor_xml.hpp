// SPDX-License-Identifier: Apache-2.0
// Profiles as XML files of Fast DDS and Cyclone DDS.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "dialect.hpp"
#include "runtime/middleware/qos_policies.hpp"

namespace tocsin::qos_tool {

/// An XML file, and what of the profiles it cannot say.
struct Exported {
  std::string xml;
  std::vector<std::string> lost;  ///< a line each, for a person
};
[[nodiscard]] Exported export_xml(Vendor vendor, const std::map<std::string, QosProfile>& profiles);

}  // namespace tocsin::qos_tool
