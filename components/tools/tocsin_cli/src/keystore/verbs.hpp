// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "foundation/role.hpp"

namespace CLI {
class App;
}

namespace tocsin::keystore_tool {

struct Options {
  std::string folder = "keystore";
  std::string name;          ///< of an identity
  std::optional<Role> role;  ///< empty: by the name
  std::string traffic_file;  ///< empty: the shipped one
  int days = 3650;
};

/// A vehicle, unless the name is that of a station: `gcs`, `gcs2`, `station`.
[[nodiscard]] Role role_by_name(const std::string& name);

void declare(CLI::App& app, Options& options);

/// What a verb prints, and its exit code.
struct Answer {
  std::string text;
  int code = 0;
};
/// create, add, permit, revoke, list or check. Throws ConfigError, EnvironmentError.
[[nodiscard]] Answer run_verb(const std::string& verb, const Options& options, std::int64_t now_s);

}  // namespace tocsin::keystore_tool
