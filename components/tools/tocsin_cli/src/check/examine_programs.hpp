// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "command_line/programs.hpp"
#include "deployment/deployment.hpp"
#include "graph.hpp"

namespace tocsin::check {

/// An error for what `tocsin launch` would not start: a program that is in none of `folders`; an
/// argument or file that a program of the stack refuses when it is asked with `--check` (the
/// emulator of the radio with its channel and walls, the simulated base). Nothing else is run.
[[nodiscard]] std::vector<Finding> examine_programs(const deployment::Deployment& deployment,
                                                    const Folders& folders);

}  // namespace tocsin::check
