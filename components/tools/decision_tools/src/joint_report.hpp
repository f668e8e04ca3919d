// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "decision/joint_fit.hpp"

namespace tocsin::tools {

/// The joint index fitted to recorded network_quality.csv files: one of a good link, one of each
/// kind of bad link. Throws ConfigError naming the file.
[[nodiscard]] decision::JointFit fit_joint_files(const std::string& good,
                                                 const std::vector<std::string>& bad);

/// The fit as parameters of a transmission_controller, with a comment on its origin and worth.
[[nodiscard]] std::string joint_text(const decision::JointFit& fit, const std::string& origin);

}  // namespace tocsin::tools
