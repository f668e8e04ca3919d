// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "deployment/deployment.hpp"
#include "graph.hpp"

namespace tocsin::check {

/// A warning for each DDS domain whose UDP ports lie where Linux takes ports for anybody from
/// (ip_local_port_range 32768 to 60999): a program that happens to have one keeps a participant
/// from starting. Domain d has the ports from 7400 + 250 d on (DDSI-RTPS 2.3, 9.6.1.1), so these
/// are 102 to 214.
[[nodiscard]] std::vector<Finding> examine_domains(const deployment::Deployment& deployment);

}  // namespace tocsin::check
