// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "kobuki_model/base_model.hpp"

namespace tocsin::kobuki {

/// The whole file. Throws ConfigError when it cannot be read.
[[nodiscard]] std::string load_text(const std::string& path);

/// What an earlier run wrote; empty when there is no file. Throws ConfigError when it is no state.
[[nodiscard]] std::optional<BaseMemory> load_memory(const std::string& path);

/// Replaces the file as a whole, so that a reader never sees half of it. False when it cannot.
[[nodiscard]] bool save_memory(const std::string& path, const BaseMemory& memory);

}  // namespace tocsin::kobuki
