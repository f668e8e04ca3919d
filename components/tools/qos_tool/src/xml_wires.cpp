// SPDX-License-Identifier: Apache-2.0
// Defaults: Fast DDS 2.9.1, RTPSParticipantAttributes.h and UDPTransportDescriptor; Cyclone DDS
// 0.10.2, its configuration guide.
#include "xml_wires.hpp"

#include <tinyxml2.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>

#include "policy_values.hpp"

namespace tocsin::qos_tool {
namespace {

using tinyxml2::XMLElement;

const Wire fast_dds_default{"a participant of Fast DDS with default settings", 65'500, true, 20};
const Wire cyclone_default{"a participant of Cyclone DDS with default settings", 14'720, true, 10};

std::string text_at(const XMLElement& base, const std::string& path) {
  const XMLElement* const found = find_at(base, path);
  return found != nullptr && found->GetText() != nullptr ? found->GetText() : "";
}

/// The largest message of each transport that the file describes.
std::map<std::string, int> transport_sizes(const XMLElement& profiles) {
  std::map<std::string, int> sizes;
  const XMLElement* const list = profiles.FirstChildElement("transport_descriptors");
  if (list == nullptr) return sizes;
  for (const auto* one = list->FirstChildElement(); one != nullptr;
       one = one->NextSiblingElement()) {
    const int size = std::atoi(text_at(*one, "maxMessageSize").c_str());
    sizes[text_at(*one, "transport_id")] = size > 0 ? size : fast_dds_default.message_bytes;
  }
  return sizes;
}

Wire wire_of(const XMLElement& participant, const std::map<std::string, int>& sizes) {
  Wire wire = fast_dds_default;
  const char* const name = participant.Attribute("profile_name");
  wire.whose = std::string("participant ") + (name == nullptr ? "" : name);
  const XMLElement* const rtps = participant.FirstChildElement("rtps");
  if (rtps == nullptr) return wire;
  const Place lease{"", "builtin/discovery_config/leaseDuration", Form::seconds, "", ""};
  if (const XMLElement* const leaf = find_at(*rtps, lease.path)) {
    wire.lease_s = seconds_of(read_value(*leaf, lease).value_or("20"));
  }
  // Without the group, named peers are asked by unicast.
  wire.multicast = find_at(*rtps, "builtin/initialPeersList") == nullptr ||
                   find_at(*rtps, "builtin/metatrafficMulticastLocatorList") != nullptr;
  const XMLElement* const own = rtps->FirstChildElement("userTransports");
  if (own == nullptr || text_at(*rtps, "useBuiltinTransports") != "false") return wire;
  wire.message_bytes = 0;
  for (const auto* one = own->FirstChildElement(); one != nullptr;
       one = one->NextSiblingElement()) {
    const auto size = sizes.find(one->GetText() == nullptr ? "" : one->GetText());
    wire.message_bytes = std::max(
        wire.message_bytes, size != sizes.end() ? size->second : fast_dds_default.message_bytes);
  }
  return wire;
}

std::vector<Wire> fast_dds_wires(const XMLElement& root) {
  const XMLElement* const profiles =
      std::string(root.Name()) == "profiles" ? &root : root.FirstChildElement("profiles");
  std::vector<Wire> wires;
  if (profiles != nullptr) {
    const auto sizes = transport_sizes(*profiles);
    for (const auto* one = profiles->FirstChildElement("participant"); one != nullptr;
         one = one->NextSiblingElement("participant")) {
      wires.push_back(wire_of(*one, sizes));
    }
  }
  return wires.empty() ? std::vector<Wire>{fast_dds_default} : wires;
}

/// `1400B`, `14 kB`: a number and a unit.
int bytes_of(const std::string& text) {
  const int number = std::atoi(text.c_str());
  return text.find("kB") != std::string::npos || text.find("KiB") != std::string::npos
             ? number * 1024
             : number;
}

std::vector<Wire> cyclone_wires(const XMLElement& root) {
  Wire wire = cyclone_default;
  const XMLElement* const domain = root.FirstChildElement("Domain");
  if (std::string(root.Name()) != "CycloneDDS" || domain == nullptr) return {wire};
  wire.whose = "the participants of this configuration";
  const int bytes = bytes_of(text_at(*domain, "General/MaxMessageSize"));
  if (bytes > 0) wire.message_bytes = bytes;
  wire.multicast = text_at(*domain, "General/AllowMulticast") != "false";
  const std::string lease = text_at(*domain, "Discovery/LeaseDuration");
  if (!lease.empty()) wire.lease_s = std::strtod(lease.c_str(), nullptr);
  return {wire};
}

}  // namespace

std::vector<Wire> wires_of(Vendor vendor, const XMLElement& root) {
  return vendor == Vendor::fast_dds ? fast_dds_wires(root) : cyclone_wires(root);
}

}  // namespace tocsin::qos_tool
