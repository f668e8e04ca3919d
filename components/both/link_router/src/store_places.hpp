// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "link_router/link_router_component.hpp"
#include "router_store.hpp"

namespace tocsin {

/// Where a router's stored samples are; nowhere without a folder and a run.
[[nodiscard]] StorePlace store_place(const Context& context,
                                     const LinkRouterComponent::Params& params);
/// Where the history of its logged topics is.
[[nodiscard]] StorePlace history_place(const Context& context,
                                       const LinkRouterComponent::Params& params);

}  // namespace tocsin
