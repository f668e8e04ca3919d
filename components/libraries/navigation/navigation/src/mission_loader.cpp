// SPDX-License-Identifier: Apache-2.0
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "foundation/error.hpp"
#include "foundation/file_cache.hpp"
#include "foundation/joined.hpp"
#include "foundation/parameters.hpp"
#include "foundation/spelling.hpp"
#include "foundation/yaml_file.hpp"
#include "navigation/mission.hpp"

namespace tocsin::navigation {
namespace {

constexpr double far_m = 1e5;

struct WaypointEntry {
  double x = 0;
  double y = 0;
  double yaw = 0;
  double send_s = 0;
  template <class Visitor>
  void visit(Visitor& v) {
    v("x", x, {-far_m, far_m}, "[m]");
    v("y", y, {-far_m, far_m}, "[m]");
    v("yaw", yaw, {-2 * pi, 2 * pi}, "[rad]");
    v("send_s", send_s, {0, Waypoint::most_send_s}, "[s]");
  }
};

Waypoint read_waypoint(const YAML::Node& node, const std::string& owner, const std::string& path) {
  const auto point = load_parameters<WaypointEntry>(node, owner, path);
  for (const char* key : {"x", "y"}) {
    if (!node.IsMap() || !node[key]) {
      throw ConfigError(owner + "." + key + ": missing" + yaml_place(path, node));
    }
  }
  return {{point.x, point.y, geometry::wrap_angle(point.yaw)}, point.send_s};
}

void check_keys(const YAML::Node& node, const std::string& path) {
  static const std::vector<std::string> keys{"name", "frame", "waypoints"};
  if (!node.IsMap()) throw ConfigError(path + ": a mission is a map with name, frame, waypoints");
  for (const auto& entry : node) {
    const std::string key = entry.first.Scalar();
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    throw ConfigError("mission." + key + ": unknown key; allowed: " + joined(keys) +
                      suggestion(keys, key) + yaml_place(path, entry.first));
  }
  if (!node["waypoints"] || !node["waypoints"].IsSequence()) {
    throw ConfigError("mission.waypoints: missing or not a list (" + path + ")");
  }
}

Mission read_yaml_mission(const std::string& path) {
  const YAML::Node node = read_yaml_file(path);
  check_keys(node, path);
  Mission mission;
  mission.name = node["name"].as<std::string>(std::filesystem::path(path).stem().string());
  mission.frame = node["frame"].as<std::string>("map");
  for (const auto& waypoint : node["waypoints"]) {
    const std::string owner = "waypoint " + std::to_string(mission.waypoints.size() + 1);
    mission.waypoints.push_back(read_waypoint(waypoint, owner, path));
  }
  return mission;
}

double number(const nlohmann::json& line, const char* key, const std::string& place) {
  const auto found = line.find(key);
  if (found == line.end() || !found->is_number()) {
    throw ConfigError(place + ": " + key + " is missing or not a number");
  }
  return found->get<double>();
}

geometry::Pose read_json_waypoint(const std::string& text, const std::string& place) {
  const auto line = nlohmann::json::parse(text, nullptr, false);
  if (!line.is_object()) throw ConfigError(place + ": not a JSON object");
  const auto value = [&](const char* key) { return number(line, key, place); };
  const geometry::Pose pose{
      value("posx"), value("posy"),
      geometry::heading_of({value("orx"), value("ory"), value("orz"), value("orw")})};
  if (std::abs(pose.x_m) > far_m || std::abs(pose.y_m) > far_m) {
    throw ConfigError(place + ": the position is not within 100 km");
  }
  return pose;
}

Mission read_json_mission(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw ConfigError(path + ": cannot be read");
  Mission mission;
  mission.name = std::filesystem::path(path).stem().string();
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    mission.waypoints.push_back({read_json_waypoint(line, path + ":" + std::to_string(number))});
  }
  return mission;
}

Mission read_mission(const std::string& path) {
  const bool is_json = std::filesystem::path(path).extension() == ".jsonl";
  Mission mission = is_json ? read_json_mission(path) : read_yaml_mission(path);
  mission.file = path;
  if (mission.waypoints.empty() || mission.waypoints.size() > most_waypoints) {
    throw ConfigError("mission.waypoints: " + std::to_string(mission.waypoints.size()) +
                      " are outside [1, " + std::to_string(most_waypoints) + "] (" + path + ")");
  }
  return mission;
}

std::string place_of(const Mission& mission, std::size_t i) {
  const geometry::Pose& p = mission.waypoints[i];
  const auto metres = [](double value) { return YAML::Dump(YAML::Node(value)); };
  return "waypoint " + std::to_string(i + 1) + " at (" + metres(p.x_m) + ", " + metres(p.y_m) + ")";
}

}  // namespace

Mission load_mission(const std::string& path) {
  static FileCache<Mission> known;
  return known.get(path, [&] { return read_mission(path); });
}

void require_free(const Mission& mission, const OccupancyMap& map, double radius_m) {
  for (std::size_t i = 0; i < mission.waypoints.size(); ++i) {
    const geometry::Pose& p = mission.waypoints[i];
    const auto fail = [&](const std::string& what) {
      throw ConfigError(place_of(mission, i) + " " + what + " (" + mission.file + ")");
    };
    const Cell cell = map.at(position(p));
    if (cell == Cell::occupied) fail("is inside a wall");
    if (cell == Cell::unknown) fail("is off the known floor of the map");
    if (map.collides(p.x_m, p.y_m, radius_m)) {
      fail("is nearer to a wall than the robot's radius of " + std::to_string(radius_m) + " m");
    }
  }
}

}  // namespace tocsin::navigation
