// SPDX-License-Identifier: Apache-2.0
#include "laser_model/obstacle_file.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::laser {
namespace {

constexpr double farthest_m = 1e5;

/// The file that is read, for errors.
class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path), file_(read_yaml_file(path)) {
    if (!file_.IsMap()) fail(file_, "the file must hold boxes, discs, walkers");
    check_keys(file_, {"boxes", "discs", "walkers"});
  }

  [[nodiscard]] Obstacles obstacles() const {
    Obstacles all;
    for (const YAML::Node& node : list(file_["boxes"], "boxes")) {
      const auto n = numbers(node, "a box is [x, y, length, width, heading_rad]", 5);
      all.boxes.push_back({{n[0], n[1], n[4]}, size(node, n[2]), size(node, n[3])});
    }
    for (const YAML::Node& node : list(file_["discs"], "discs")) {
      const auto n = numbers(node, "a disc is [x, y, radius]", 3);
      all.discs.push_back({{n[0], n[1]}, size(node, n[2])});
    }
    for (const YAML::Node& node : list(file_["walkers"], "walkers")) {
      all.walkers.push_back(walker(node));
    }
    return all;
  }

 private:
  [[noreturn]] void fail(const YAML::Node& node, const std::string& what) const {
    throw ConfigError("obstacles: " + what + yaml_place(path_, node));
  }

  void check_keys(const YAML::Node& map, const std::vector<std::string>& known) const {
    for (const auto& entry : map) {
      const auto key = entry.first.as<std::string>();
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      fail(entry.first, "'" + key + "' is not one of: " + joined(known));
    }
  }

  [[nodiscard]] YAML::Node list(const YAML::Node& node, const char* name) const {
    if (!node) return YAML::Node(YAML::NodeType::Sequence);
    if (!node.IsSequence()) fail(node, std::string(name) + " must be a list");
    return node;
  }

  [[nodiscard]] double number(const YAML::Node& node, const char* form) const {
    double value = 0;
    const bool is_number = node.IsScalar() && YAML::convert<double>::decode(node, value);
    if (!is_number || !(std::abs(value) <= farthest_m)) {
      fail(node, std::string(form) + ", numbers in [-100000, 100000]");
    }
    return value;
  }

  [[nodiscard]] std::vector<double> numbers(const YAML::Node& node, const char* form,
                                            std::size_t count) const {
    if (!node.IsSequence() || node.size() != count) fail(node, form);
    std::vector<double> values;
    for (const YAML::Node& one : node) values.push_back(number(one, form));
    return values;
  }

  [[nodiscard]] double size(const YAML::Node& node, double value_m) const {
    if (!(value_m >= 0.005 && value_m <= 100)) {
      fail(node, fmt::format("a size of {} m is outside [0.005, 100]", value_m));
    }
    return value_m;
  }

  [[nodiscard]] double option(const YAML::Node& map, const char* key, double usual, double low,
                              double high) const {
    const YAML::Node node = map[key];
    const double value = node ? number(node, key) : usual;
    if (value >= low && value <= high) return value;
    fail(node, fmt::format("{}: {} is outside [{}, {}]", key, value, low, high));
  }

  [[nodiscard]] Walker walker(const YAML::Node& node) const {
    constexpr const char* form = "a walker is {way: [[x, y], [x, y], ...], speed_mps: 0.8}";
    if (!node.IsMap()) fail(node, form);
    check_keys(node, {"way", "speed_mps", "pause_s", "radius_m"});
    Walker walker;
    const YAML::Node way = node["way"];
    if (!way || !way.IsSequence() || way.size() < 2) fail(node, form);
    double length_m = 0;
    for (const YAML::Node& corner : way) {
      const auto n = numbers(corner, form, 2);
      walker.way.push_back({n[0], n[1]});
      if (walker.way.size() < 2) continue;
      length_m += geometry::distance(walker.way[walker.way.size() - 2], walker.way.back());
    }
    if (length_m < 0.01) fail(way, "the way of a walker must be longer than 0.01 m");
    walker.speed_mps = option(node, "speed_mps", walker.speed_mps, 0.05, 5);
    walker.pause_s = option(node, "pause_s", walker.pause_s, 0, 3600);
    walker.radius_m = option(node, "radius_m", walker.radius_m, 0.05, 1);
    return walker;
  }

  std::string path_;
  YAML::Node file_;
};

}  // namespace

Obstacles load_obstacles(const std::string& path) { return Reader(path).obstacles(); }

}  // namespace tocsin::laser
