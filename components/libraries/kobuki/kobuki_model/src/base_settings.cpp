// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/base_settings.hpp"

#include <cmath>
#include <cstdio>

#include "foundation/error.hpp"
#include "foundation/file_cache.hpp"
#include "foundation/parameters.hpp"
#include "foundation/spelling.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::kobuki {
namespace {

BaseSettings read_settings(const std::string& path) {
  const YAML::Node file = read_yaml_file(path);
  if (!file.IsMap()) throw ConfigError("kobuki_simulator: must be a map (" + path + ")");
  for (const auto& entry : file) {
    const std::string key = entry.first.Scalar();
    if (key == "model" || key == "line") continue;
    throw ConfigError("kobuki_simulator." + key + ": unknown key; allowed: [model, line]" +
                      suggestion({"model", "line"}, key) + yaml_place(path, entry.first));
  }
  return {load_parameters<ModelParams>(file["model"], "kobuki_simulator.model", path),
          load_parameters<LineParams>(file["line"], "kobuki_simulator.line", path)};
}

}  // namespace

BaseSettings load_base_settings(const std::string& path) {
  static FileCache<BaseSettings> known;
  return known.get(path, [&] { return read_settings(path); });
}

geometry::Pose parse_pose(const std::string& name, const std::string& text) {
  geometry::Pose pose;
  char rest = 0;
  const int read =
      std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &pose.x_m, &pose.y_m, &pose.heading_rad, &rest);
  if (read != 3 || !is_finite(pose)) {
    throw ConfigError(name + ": '" + text + "' is not X,Y,YAW in m, m, rad");
  }
  return pose;
}

}  // namespace tocsin::kobuki
