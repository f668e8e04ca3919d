// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "deployment/deployment.hpp"
#include "graph.hpp"

namespace tocsin::check {

/// Whether the routers of a secured link have identities that their peers accept at `now_s` [s
/// since the Unix epoch], and that allow all that traffic.yaml has them send and hear.
[[nodiscard]] std::vector<Finding> examine_security(const deployment::Deployment& deployment,
                                                    std::int64_t now_s);

}  // namespace tocsin::check
