// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "plan/plan.hpp"

namespace tocsin::experiment {

/// Everything that decides the results, as YAML: build_version(), the experiment file, and the text
/// of each channel, mission and file of fitted parameters.
/// Two experiments with the same settings give the same bytes. Throws ConfigError for a file that
/// cannot be read.
[[nodiscard]] std::string settings_text(const Experiment& experiment, const std::vector<Run>& plan);

/// Version of the package, and a number that changes with the program and the libraries that it has
/// loaded by now: after check_plan(), the components that the runs use and no others.
[[nodiscard]] std::string build_version();

/// Finds out before the first run what is wrong with any of them: files, unknown components and
/// keys, ranges. Loads the component libraries. Throws ConfigError that names the entry.
void check_plan(const std::vector<Run>& plan, const Timing& timing, const std::string& share);

}  // namespace tocsin::experiment
