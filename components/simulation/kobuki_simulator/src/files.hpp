// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/pose.hpp"
#include "kobuki_model/base_model.hpp"
#include "kobuki_model/serial_line.hpp"

namespace tocsin::kobuki {

struct Settings {
  ModelParams model;
  LineParams line;
};

/// Reads `model:` and `line:`, both optional. Throws ConfigError.
[[nodiscard]] Settings load_settings(const std::string& path);

/// The whole file. Throws ConfigError when it cannot be read.
[[nodiscard]] std::string load_text(const std::string& path);

/// "X,Y,YAW" of the option `name`. Throws ConfigError.
[[nodiscard]] geometry::Pose parse_pose(const std::string& name, const std::string& text);

/// What an earlier run wrote; empty when there is no file. Throws ConfigError when it is no state.
[[nodiscard]] std::optional<BaseMemory> load_memory(const std::string& path);

/// Replaces the file as a whole, so that a reader never sees half of it. False when it cannot.
[[nodiscard]] bool save_memory(const std::string& path, const BaseMemory& memory);

}  // namespace tocsin::kobuki
