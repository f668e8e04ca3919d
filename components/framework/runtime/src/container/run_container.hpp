// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "deployment/deployment.hpp"

namespace tocsin {

/// Runs a container until SIGINT, SIGTERM or a component asks for the end. Returns the exit code.
[[nodiscard]] int run_container(const deployment::Deployment& deployment,
                                const deployment::Host& host,
                                const deployment::Container& container);

}  // namespace tocsin
