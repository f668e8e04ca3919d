// SPDX-License-Identifier: Apache-2.0
// What the component's parameters, and the run that it is in, mean for its parts.
#pragma once

#include "operator_server/operator_server_component.hpp"
#include "web_server.hpp"

namespace tocsin::foxglove {

/// Throws ConfigError naming the parameter.
[[nodiscard]] HubSettings hub_settings(const Context& context,
                                       const OperatorServerComponent::Params& params);

/// Throws ConfigError naming the parameter, or the file that cannot be read.
[[nodiscard]] WebSettings web_settings(const Context& context,
                                       const OperatorServerComponent::Params& params);

}  // namespace tocsin::foxglove
