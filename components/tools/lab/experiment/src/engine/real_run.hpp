// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine/simulate.hpp"

namespace tocsin::experiment {

/// Plays a run through the real stack in real time: `tocsin-launch` with the same settings, in
/// network namespaces of its own, then measured from its recordings. Its folder is
/// `real/<run>.run` of the results.
[[nodiscard]] RunResult drive(const Run& run, const Timing& timing, const Places& places);

/// The command line that `drive` starts.
[[nodiscard]] std::vector<std::string> launch_command(const Run& run, const Timing& timing,
                                                      const Places& places);

}  // namespace tocsin::experiment
