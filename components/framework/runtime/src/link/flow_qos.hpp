// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "runtime/middleware/link_bus.hpp"
#include "runtime/middleware/qos_profile.hpp"

namespace tocsin {

/// What a flow's writer offers on the host.
[[nodiscard]] QosProfile offered(const Flow& flow);
/// On the link each sample is sent once, when the router says so.
[[nodiscard]] QosProfile offered_on_link(const Flow& flow);

}  // namespace tocsin
