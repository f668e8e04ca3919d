// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/pose.hpp"
#include "kobuki_model/model_params.hpp"
#include "kobuki_model/serial_line.hpp"

namespace tocsin::kobuki {

/// What a file such as config/kobuki/*.yaml says of a simulated base.
struct BaseSettings {
  ModelParams model;
  LineParams line;
};

/// Reads `model:` and `line:`, both optional. What has been read is kept until the file changes.
/// Any thread. Throws ConfigError naming the key, and the place of one that is not known.
[[nodiscard]] BaseSettings load_base_settings(const std::string& path);

/// "X,Y,YAW" [m, m, rad] of the option `name`. Throws ConfigError.
[[nodiscard]] geometry::Pose parse_pose(const std::string& name, const std::string& text);

}  // namespace tocsin::kobuki
