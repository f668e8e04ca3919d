// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "deployment/deployment.hpp"

namespace tocsin::deployment {

/// "host/process" of every process, in starting order.
[[nodiscard]] std::vector<std::string> process_names(const Deployment& deployment);

/// Leaves of `stop_when_exits` what is there.
void keep_own_ends(Deployment& part);

/// Whether it is one of several.
[[nodiscard]] bool is_vehicle(const Deployment& deployment, const std::string& name);

}  // namespace tocsin::deployment
