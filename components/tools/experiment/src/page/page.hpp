// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tocsin::experiment {

/// Writes report.html and figures/*.png of an experiment's results, and prints where. Throws
/// ConfigError for a folder without results, EnvironmentError without gnuplot or room on the disk.
int write_page(const std::string& folder);

}  // namespace tocsin::experiment
