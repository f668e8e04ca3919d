// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "decision/density.hpp"
#include "decision/policy_params.hpp"

namespace tocsin::tools {

/// Parameters of a policy from a model file (YAML, the keys of PolicyParams) and `key=value`
/// overrides; an empty path means the defaults. Throws ConfigError.
[[nodiscard]] decision::PolicyParams load_model(const std::string& path,
                                                const std::vector<std::string>& overrides);

/// The text of a model file: both laws as keys of PolicyParams, with a comment on their origin.
[[nodiscard]] std::string model_text(const decision::Density& good, const decision::Density& bad,
                                     const std::string& origin);

/// Writes a text file whole. Throws ConfigError when it cannot be written.
void write_text(const std::string& path, const std::string& text);

}  // namespace tocsin::tools
