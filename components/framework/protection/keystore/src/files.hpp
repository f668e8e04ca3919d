// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "foundation/error.hpp"
#include "foundation/read_file.hpp"

namespace tocsin::keystore {

/// Nothing when it cannot be read, or is larger than any file of a keystore.
[[nodiscard]] inline std::optional<std::string> content_of(const std::string& path) {
  constexpr std::size_t longest = 1U << 20U;
  try {
    return read_file(path, longest);
  } catch (const ConfigError&) {
    return std::nullopt;
  }
}

}  // namespace tocsin::keystore
