// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace tocsin {

constexpr std::size_t longest_yaml = std::size_t{1} << 19U;  ///< [byte]
constexpr std::size_t most_yaml_nodes = 100'000;             ///< with what aliases stand for
constexpr std::size_t deepest_yaml = 32;

/// What stands for a text in errors.
struct YamlOrigin {
  std::string name;
  bool has_lines;  ///< false for a text of one line, as of an option
};

/// Walks over a YAML text without keeping it. Throws ConfigError, with origin, line and reason,
/// when it is not one YAML document within the limits of YamlSources::read().
void check_yaml(const std::string& text, const YamlOrigin& origin);

}  // namespace tocsin
