// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "runtime/middleware/link_bus.hpp"

namespace tocsin {

/// The user data by which a router announces a flow on the link: what the writers on its host
/// announce, and what they offer there: "tocsinflow=reliable,transient_local,1,inf;". Behind that
/// `stored`, and `second` of a writer on the second path.
[[nodiscard]] std::string announcement_of(const Flow& flow);

/// Takes that out of `flow.user_data` again, which holds all that was announced. What is missing or
/// makes no sense leaves the flow as it is: best effort, volatile, depth 1.
void read_announcement(Flow& flow);

}  // namespace tocsin
