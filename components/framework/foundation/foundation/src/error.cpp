// SPDX-License-Identifier: Apache-2.0
#include "foundation/error.hpp"

#include "foundation/printable.hpp"

namespace tocsin {

std::string error_line(const std::string& text) { return printable(text, 4096); }

ConfigError::ConfigError(const std::string& text) : std::runtime_error(error_line(text)) {}

EnvironmentError::EnvironmentError(const std::string& text)
    : std::runtime_error(error_line(text)) {}

}  // namespace tocsin
