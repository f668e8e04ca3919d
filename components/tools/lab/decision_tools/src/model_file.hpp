// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "decision/density.hpp"

namespace tocsin::tools {

/// The text of a model file: both laws as keys of PolicyParams, with a comment on their origin.
[[nodiscard]] std::string model_text(const decision::Density& good, const decision::Density& bad,
                                     const std::string& origin);

/// Throws ConfigError when no policy would take the model: laws the wrong way round or without mass
/// on the scale, a parameter beyond its range.
void check_model(const std::string& text);

/// Writes a text file whole. Throws ConfigError when it cannot be written.
void write_text(const std::string& path, const std::string& text);

}  // namespace tocsin::tools
