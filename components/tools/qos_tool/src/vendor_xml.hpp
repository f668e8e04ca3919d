// SPDX-License-Identifier: Apache-2.0
// Profiles to and from the XML files of Fast DDS and Cyclone DDS.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "dialect.hpp"
#include "lint.hpp"
#include "runtime/middleware/qos_policies.hpp"

namespace tocsin::qos_tool {

/// An XML file, and what of the profiles it cannot say.
struct Exported {
  std::string xml;
  std::vector<std::string> lost;  ///< a line each, for a person
};
[[nodiscard]] Exported export_xml(Vendor vendor, const std::map<std::string, QosProfile>& profiles);

/// The profiles of an XML file, and what of the file they cannot say.
struct Imported {
  Vendor vendor;
  std::map<std::string, QosProfile> profiles;
  std::vector<std::string> lost;  ///< a line each, with the place in the file
  std::vector<Wire> wires;        ///< what its participants do on the network
};
/// `name` stands for the file in errors. Throws ConfigError when it is no XML, of neither vendor,
/// or says what no profile of ours can be.
[[nodiscard]] Imported import_xml(const std::string& text, const std::string& name);

/// A QoS file with these profiles.
[[nodiscard]] std::string qos_file(const std::map<std::string, QosProfile>& profiles);

}  // namespace tocsin::qos_tool
