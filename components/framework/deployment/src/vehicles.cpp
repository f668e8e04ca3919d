// SPDX-License-Identifier: Apache-2.0
#include "vehicles.hpp"

#include <utility>

#include "foundation/error.hpp"
#include "foundation/role.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::deployment {
namespace {

bool is_for_each(const YAML::Node& container) {
  return container.IsMap() && container["each_vehicle"] &&
         container["each_vehicle"].as<bool>(false);
}

/// Leaves the containers of a host that are for each vehicle, or the others. What is no list is
/// left for its reader to refuse.
void keep_containers(YAML::Node host, bool for_each) {
  const YAML::Node all = host["containers"];
  if (!all.IsDefined() || !all.IsSequence()) return;
  YAML::Node kept(YAML::NodeType::Sequence);
  for (const auto& one : all) {
    if (is_for_each(one) == for_each) kept.push_back(one);
  }
  host["containers"] = kept;
}

VehicleEntry read_vehicle(const std::string& name, const YAML::Node& node, bool is_relay,
                          const YamlSources& sources) {
  VehicleEntry vehicle{name, "", {}};
  if (is_relay && node.IsNull()) return vehicle;
  const Section section(node, "vehicles." + name, sources, {"address", "variables"});
  if (!is_relay) vehicle.address = section.required_text("address");
  if (is_relay && section.find("address").IsDefined())
    section.fail("address", "is none of a vehicle behind a relay: its site's is that of the host");
  for (const auto& one : read_variables(section, sources)) vehicle.variables.push_back(one.first);
  return vehicle;
}

}  // namespace

Variables read_variables(const Section& section, const YamlSources& sources) {
  const YAML::Node node = section.find("variables");
  if (!node.IsDefined() || node.IsNull()) return {};
  const Section names(node, "variables", sources);
  Variables variables;
  for (const auto& entry : node) {
    const std::string name = entry.first.Scalar();
    check_name(name, "variables", entry.first, sources);
    for (const char* const taken : {"run_dir", "seed", "share", "vehicle"}) {
      if (name == taken) names.fail(name, "has a meaning already");
    }
    variables[name] = names.required_text(name);
  }
  return variables;
}

std::vector<VehicleEntry> read_vehicles(const YAML::Node& root, bool is_relay,
                                        const YamlSources& sources) {
  const YAML::Node node = root["vehicles"];
  if (!node.IsDefined()) return {};
  const Section all(node, "vehicles", sources);
  std::vector<VehicleEntry> vehicles;
  for (const auto& entry : node) {
    const std::string name = entry.first.Scalar();
    check_name(name, "vehicles", entry.first, sources);
    if (name == to_string(Role::gcs))
      all.fail(name, "is the station's role, and no vehicle's name");
    vehicles.push_back(read_vehicle(name, entry.second, is_relay, sources));
  }
  if (vehicles.empty()) {
    throw ConfigError("vehicles: must name at least one" + yaml_place(sources, node));
  }
  return vehicles;
}

std::string vehicle_host(const YAML::Node& root, const YamlSources& sources) {
  const YAML::Node hosts = root["hosts"];
  std::vector<std::string> found;
  if (hosts.IsDefined() && hosts.IsMap()) {
    for (const auto& host : hosts) {
      const YAML::Node role = host.second.IsMap() ? host.second["role"] : YAML::Node();
      if (role.IsDefined() && role.IsScalar() && role_of(role.Scalar()) == Role::uxv) {
        found.push_back(host.first.Scalar());
      }
    }
  }
  if (found.size() == 1) return found.front();
  throw ConfigError("vehicles: are like the one host of role uxv, of which `hosts` has " +
                    std::to_string(found.size()) + yaml_place(sources, root["vehicles"]));
}

void keep_common(const YAML::Node& root, bool is_relay, const YamlSources& sources) {
  YAML::Node hosts = root["hosts"];
  const std::string like = vehicle_host(root, sources);
  if (!is_relay) hosts.remove(like);
  YAML::Node(root).remove("vehicles");
  for (const auto& host : hosts) {
    if (host.second.IsMap()) keep_containers(host.second, false);
  }
}

void keep_own(const YAML::Node& root, bool is_relay, const YamlSources& sources) {
  const YAML::Node hosts = root["hosts"];
  const std::string vehicle = vehicle_host(root, sources);
  for (const auto& host : hosts) {
    const bool stays = host.first.Scalar() == vehicle && !is_relay;
    if (stays || !host.second.IsMap()) continue;
    YAML::Node other = host.second;
    other.remove("programs");
    keep_containers(other, true);
  }
}

}  // namespace tocsin::deployment
