// SPDX-License-Identifier: Apache-2.0
#include "camera/walls.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>

#include "foundation/error.hpp"
#include "foundation/file_cache.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::camera {
namespace {

[[noreturn]] void fail(const std::string& path, const YAML::Node& node, const std::string& what) {
  throw ConfigError("walls: " + what + yaml_place(path, node));
}

double number(const std::string& path, const YAML::Node& node) {
  double value = 0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
    fail(path, node, "a wall is five numbers: x1, y1, x2, y2 [m], loss [dB]");
  }
  return value;
}

Wall wall(const std::string& path, const YAML::Node& node) {
  if (!node.IsSequence() || node.size() != 5) {
    fail(path, node, "a wall is five numbers: x1, y1, x2, y2 [m], loss [dB]");
  }
  const double loss_db = number(path, node[4]);
  if (loss_db < 0) fail(path, node, "a loss is not negative");
  return {number(path, node[0]), number(path, node[1]), number(path, node[2]),
          number(path, node[3]), loss_db == 0};
}

std::vector<Wall> read_walls(const std::string& path) {
  const YAML::Node file = read_yaml_file(path);
  const YAML::Node list = file.IsMap() ? file["walls"] : YAML::Node();
  if (!list || !list.IsSequence() || list.size() == 0) {
    fail(path, file, "the file must hold a list `walls` with at least one wall");
  }
  std::vector<Wall> walls;
  for (const YAML::Node& node : list) walls.push_back(wall(path, node));
  return walls;
}

}  // namespace

std::vector<Wall> load_walls(const std::string& path) {
  static FileCache<std::vector<Wall>> known;
  return known.get(path, [&] { return read_walls(path); });
}

}  // namespace tocsin::camera
