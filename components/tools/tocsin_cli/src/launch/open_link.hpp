// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "deployment/deployment.hpp"

namespace tocsin::cli {

/// What a launch says when a host's link is open: on a real interface, without `security`, anybody
/// in reach of the radio speaks on it. Empty for an emulated radio, loopback, and a host without a
/// router.
[[nodiscard]] std::optional<std::string> open_link_warning(
    const deployment::Deployment& deployment);

}  // namespace tocsin::cli
