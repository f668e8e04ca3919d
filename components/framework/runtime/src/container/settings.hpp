// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "foundation/error.hpp"

namespace tocsin {

/// A YAML map of settings "key=value"; no value is an empty text. Throws ConfigError for one
/// without key or '='.
[[nodiscard]] inline std::string settings_text(const std::vector<std::string>& settings) {
  std::string text;
  for (const std::string& setting : settings) {
    const std::size_t at = setting.find('=');
    if (at == std::string::npos || at == 0) {
      throw ConfigError("--set " + setting + ": is not key=value");
    }
    const std::string value = setting.substr(at + 1);
    text += setting.substr(0, at) + ": " + (value.empty() ? "''" : value) + "\n";
  }
  return text;
}

}  // namespace tocsin
