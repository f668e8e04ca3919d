// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "lint.hpp"

namespace tocsin::qos_tool {

/// Flow controllers by which a writer may wait for ever, or a command behind a stream.
void starving_flow(const LintInput& input, const char* rule, std::vector<Finding>& found);

}  // namespace tocsin::qos_tool
