// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tocsin::tools {

/// Draws a picture, as report::draw takes it, to PREFIX.png and PREFIX.svg. Throws ConfigError when
/// the folder is not there, else as report::draw.
void draw(const nlohmann::json& picture, const std::string& prefix);

}  // namespace tocsin::tools
