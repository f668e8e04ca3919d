// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace tocsin {

/// A bad file, parameter or command line. Thrown at start-up only, from constructors and loaders;
/// the program prints the text as one line and ends with exit code 2.
/// The text names the thing, the value and what is allowed.
class ConfigError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The machine lacks something that the program needs (a tool, a device, a privilege).
/// Printed as one line, exit code 1.
class EnvironmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace tocsin
