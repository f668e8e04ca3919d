// SPDX-License-Identifier: Apache-2.0
#include "navigation/mission_writer.hpp"

#include <yaml-cpp/yaml.h>

#include <array>
#include <cstdio>

#include "foundation/error.hpp"
#include "foundation/replace_file.hpp"

namespace tocsin::navigation {
namespace {

std::string line_of(const Waypoint& waypoint) {
  std::array<char, 128> text{};
  const int length = std::snprintf(text.data(), text.size(), "  - {x: %.4f, y: %.4f, yaw: %.4f",
                                   waypoint.x_m, waypoint.y_m, waypoint.heading_rad);
  std::string line(text.data(), static_cast<std::size_t>(length));
  if (waypoint.send_s > 0) line += ", send_s: " + YAML::Dump(YAML::Node(waypoint.send_s));
  return line + "}\n";
}

}  // namespace

std::string mission_text(const Mission& mission) {
  std::string text = "name: " + YAML::Dump(YAML::Node(mission.name)) +
                     "\nframe: " + YAML::Dump(YAML::Node(mission.frame)) + "\nwaypoints:\n";
  for (const Waypoint& waypoint : mission.waypoints) text += line_of(waypoint);
  return text;
}

void write_mission(const Mission& mission, const std::string& path) {
  const std::size_t count = mission.waypoints.size();
  if (count == 0 || count > most_waypoints) {
    throw ConfigError(path + ": the mission has " + std::to_string(count) +
                      " waypoints, outside [1, " + std::to_string(most_waypoints) + "]");
  }
  const auto error = replace_file(path, mission_text(mission));
  if (error) throw ConfigError(path + ": cannot be written: " + error.message());
}

}  // namespace tocsin::navigation
