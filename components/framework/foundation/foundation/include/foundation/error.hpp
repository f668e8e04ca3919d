// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace tocsin {

/// A bad file, parameter or command line. Thrown at start-up only, from constructors and loaders;
/// the program prints the text as one line and ends with exit code 2.
/// The text names the thing, the value and what is allowed. What it quotes is made printable here.
class ConfigError : public std::runtime_error {
 public:
  explicit ConfigError(const std::string& text);
};

/// The machine lacks something that the program needs (a tool, a device, a privilege).
/// Printed as one line, exit code 1.
class EnvironmentError : public std::runtime_error {
 public:
  explicit EnvironmentError(const std::string& text);
};

/// The text of an error as it may be shown: on one line (see printable()), of at most 4096 bytes of
/// the original.
[[nodiscard]] std::string error_line(const std::string& text);

}  // namespace tocsin
