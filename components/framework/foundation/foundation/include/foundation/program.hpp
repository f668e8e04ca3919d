// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <exception>
#include <string>

#include "foundation/error.hpp"

namespace tocsin {

/// Runs the body of a program's main and returns its exit code. An error ends the program with one
/// line on stderr: code 2 for a ConfigError, which the user can correct, 1 for everything else.
template <class Body>
[[nodiscard]] int run_program(const std::string& name, Body body) {
  try {
    return body();
  } catch (const ConfigError& error) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), error_line(error.what()).c_str());
    return 1;
  }
}

}  // namespace tocsin
