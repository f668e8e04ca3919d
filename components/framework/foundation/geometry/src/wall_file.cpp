// SPDX-License-Identifier: Apache-2.0
#include "geometry/wall_file.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <cmath>

#include "foundation/error.hpp"
#include "foundation/file_cache.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::geometry {
namespace {

[[noreturn]] void fail(const std::string& path, const YAML::Node& node, const std::string& what) {
  throw ConfigError("walls: " + what + yaml_place(path, node));
}

[[noreturn]] void fail_form(const std::string& path, const YAML::Node& node) {
  fail(path, node, "a wall is [x1, y1, x2, y2, loss_db], five finite numbers");
}

double number(const std::string& path, const YAML::Node& node) {
  double value = 0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
    fail_form(path, node);
  }
  return value;
}

Wall wall(const std::string& path, const YAML::Node& node) {
  if (!node.IsSequence() || node.size() != 5) fail_form(path, node);
  const double loss_db = number(path, node[4]);
  if (loss_db < 0 || loss_db > 100) {
    fail(path, node, fmt::format("loss_db: {} is outside [0, 100]", loss_db));
  }
  return {number(path, node[0]), number(path, node[1]), number(path, node[2]),
          number(path, node[3]), loss_db};
}

std::vector<Wall> read_walls(const std::string& path) {
  const YAML::Node file = read_yaml_file(path);
  const YAML::Node list = file.IsMap() ? file["walls"] : YAML::Node();
  if (!list || !list.IsSequence()) fail(path, file, "the file must hold a list of that name");
  std::vector<Wall> walls;
  for (const YAML::Node& node : list) walls.push_back(wall(path, node));
  return walls;
}

}  // namespace

std::vector<Wall> load_walls(const std::string& path) {
  static FileCache<std::vector<Wall>> known;
  return known.get(path, [&] { return read_walls(path); });
}

}  // namespace tocsin::geometry
