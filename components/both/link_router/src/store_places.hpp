// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "backfill/backfill_link.hpp"
#include "link_router/link_router_component.hpp"

namespace tocsin {

/// With the folders of stored samples and of the history; without one where there is neither a
/// `store_directory` nor a folder of the run.
[[nodiscard]] BackfillLink::Params backfill_params(const Context& context,
                                                   const LinkRouterComponent::Params& params);

}  // namespace tocsin
