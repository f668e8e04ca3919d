// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tocsin::tools {

/// Draws `script` (gnuplot commands without terminal and output, data inline as $blocks) to
/// PREFIX.png and PREFIX.svg. Throws EnvironmentError when gnuplot is missing or fails.
void draw(const std::string& script, const std::string& prefix);

}  // namespace tocsin::tools
