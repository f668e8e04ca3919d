// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/channel_files.hpp"

#include <cmath>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "foundation/yaml_file.hpp"
#include "radio_channel/outages.hpp"

namespace tocsin::radio {
namespace {

double number(const YAML::Node& node, const std::string& path) {
  double value = 0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
    throw ConfigError("walls: not a finite number" + yaml_place(path, node));
  }
  return value;
}

Wall wall_from(const YAML::Node& node, const std::string& path) {
  if (!node.IsSequence() || node.size() != 5) {
    throw ConfigError("walls: a wall is [x1, y1, x2, y2, loss_db]" + yaml_place(path, node));
  }
  const Wall wall{number(node[0], path), number(node[1], path), number(node[2], path),
                  number(node[3], path), number(node[4], path)};
  if (wall.loss_db < 0 || wall.loss_db > 100) {
    throw ConfigError("walls: loss_db is outside [0, 100]" + yaml_place(path, node));
  }
  return wall;
}

}  // namespace

ChannelParams load_channel(const std::string& path) {
  const YAML::Node file = read_yaml_file(path);
  if (!file.IsMap() || !file["radio_channel"] || file.size() != 1) {
    throw ConfigError("radio_channel: must be the one key of the file" + yaml_place(path, file));
  }
  auto params = load_parameters<ChannelParams>(file["radio_channel"], "radio_channel", path);
  (void)Outages(params.outages_s, Time{});  // throws on a bad script
  return params;
}

std::vector<Wall> load_walls(const std::string& path) {
  const YAML::Node file = read_yaml_file(path);
  if (!file.IsMap() || !file["walls"] || !file["walls"].IsSequence()) {
    throw ConfigError("walls: the file has no list of that name" + yaml_place(path, file));
  }
  std::vector<Wall> walls;
  for (const YAML::Node& node : file["walls"]) walls.push_back(wall_from(node, path));
  return walls;
}

}  // namespace tocsin::radio
