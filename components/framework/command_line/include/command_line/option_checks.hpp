// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace tocsin {

// Checks of options whose texts name the value and what is allowed. CLI11's own print the largest
// double in 309 digits.

[[nodiscard]] CLI::Validator at_least_zero();
[[nodiscard]] CLI::Validator above_zero();

/// A seed of everything random: a whole number from 0 to 2147483647.
[[nodiscard]] CLI::Validator is_seed();

/// What is wrong with a command line that CLI11 refused with `error`: a misspelt option or verb
/// with what is like it, else CLI11's own words.
[[nodiscard]] std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace tocsin
