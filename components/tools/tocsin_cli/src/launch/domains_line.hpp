// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "deployment/deployment.hpp"

namespace tocsin::cli {

/// "ROS_DOMAIN_ID: 0 on uxv, 1 on gcs; the link has 2": where tools of ROS 2 find each host.
[[nodiscard]] std::string domains_line(const deployment::Deployment& deployment);

}  // namespace tocsin::cli
