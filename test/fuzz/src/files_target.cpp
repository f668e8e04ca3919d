// SPDX-License-Identifier: Apache-2.0
#include "files_target.hpp"

#include <filesystem>

#include "deployment/deployment.hpp"
#include "geometry/wall_file.hpp"
#include "navigation/map_loader.hpp"
#include "navigation/mission.hpp"
#include "radio_channel/channel_files.hpp"
#include "runtime/middleware/qos_profile.hpp"
#include "runtime/middleware/traffic_rules.hpp"
#include "simulation/faults.hpp"

namespace tocsin::fuzz {
namespace {

void load_bringup(const std::string& path) {
  deployment::Overrides overrides;
  overrides.run_dir = "/nowhere";
  overrides.share = std::filesystem::path(path).parent_path().parent_path();
  (void)deployment::load_deployment(path, overrides);
}

/// A file of parameters is read by the bringup file beside which it lies.
void load_parameters_file(const std::string& path) {
  const auto share = std::filesystem::path(path).parent_path().parent_path();
  load_bringup(share / "bringup/mission.yaml");
}

void load_traffic(const std::string& path) {
  for (const Role role : roles) (void)TrafficRules(path, role);
}

}  // namespace

const std::vector<FileKind>& file_kinds() {
  static const std::vector<FileKind> all{
      {"bringup/mission.yaml", load_bringup},
      {"config/mission.yaml", load_parameters_file},
      {"config/qos.yaml", [](const std::string& path) { (void)QosProfiles(path); }},
      {"config/traffic.yaml", load_traffic},
      {"config/missions/mission_a.yaml",
       [](const std::string& path) { (void)navigation::load_mission(path); }},
      {"config/maps/classroom.yaml",
       [](const std::string& path) { (void)navigation::load_map(path); }},
      {"config/maps/classroom.walls.yaml",
       [](const std::string& path) { (void)geometry::load_walls(path); }},
      {"config/radio/classroom.yaml",
       [](const std::string& path) { (void)radio::load_channel(path); }},
      {"config/faults.yaml", [](const std::string& path) { (void)simulation::load_faults(path); }},
  };
  return all;
}

}  // namespace tocsin::fuzz
