// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tocsin::tools {

/// Draws `script` (gnuplot commands without terminal and output, data inline as $blocks) to
/// PREFIX.png and PREFIX.svg. Throws EnvironmentError when gnuplot is missing or fails.
void draw(const std::string& script, const std::string& prefix);

/// `text` as a gnuplot string in double quotes.
[[nodiscard]] std::string quoted(const std::string& text);

}  // namespace tocsin::tools
