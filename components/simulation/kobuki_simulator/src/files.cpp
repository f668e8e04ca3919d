// SPDX-License-Identifier: Apache-2.0
#include "files.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "foundation/replace_file.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::kobuki {
Settings load_settings(const std::string& path) {
  const YAML::Node file = read_yaml_file(path);
  if (!file.IsMap()) throw ConfigError("kobuki_simulator: must be a map (" + path + ")");
  for (const auto& entry : file) {
    const std::string key = entry.first.Scalar();
    if (key == "model" || key == "line") continue;
    throw ConfigError("kobuki_simulator." + key + ": unknown key; allowed: [model, line]" +
                      yaml_place(path, entry.first));
  }
  return {load_parameters<ModelParams>(file["model"], "kobuki_simulator.model", path),
          load_parameters<LineParams>(file["line"], "kobuki_simulator.line", path)};
}

std::string load_text(const std::string& path) {
  std::ifstream in(path);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw ConfigError(path + ": cannot be read");
  return text;
}

geometry::Pose parse_pose(const std::string& name, const std::string& text) {
  geometry::Pose pose;
  char rest = 0;
  const int read =
      std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &pose.x_m, &pose.y_m, &pose.heading_rad, &rest);
  if (read != 3 || !std::isfinite(pose.x_m + pose.y_m + pose.heading_rad)) {
    throw ConfigError(name + ": '" + text + "' is not X,Y,YAW in m, m, rad");
  }
  return pose;
}

std::optional<BaseMemory> load_memory(const std::string& path) {
  std::ifstream in(path);
  if (!in) return std::nullopt;
  BaseMemory m;
  in >> m.pose.x_m >> m.pose.y_m >> m.pose.heading_rad >> m.left_ticks >> m.right_ticks >>
      m.gyro_rad >> m.clock_s >> m.charge;
  if (!in) throw ConfigError(path + ": is not a state of the simulator; remove it");
  return m;
}

bool save_memory(const std::string& path, const BaseMemory& m) {
  std::ostringstream out;
  out.precision(17);
  out << m.pose.x_m << ' ' << m.pose.y_m << ' ' << m.pose.heading_rad << ' ' << m.left_ticks << ' '
      << m.right_ticks << ' ' << m.gyro_rad << ' ' << m.clock_s << ' ' << m.charge << '\n';
  return !replace_file(path, out.str(), Sync::no);
}

}  // namespace tocsin::kobuki
