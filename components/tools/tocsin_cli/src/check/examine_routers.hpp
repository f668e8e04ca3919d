// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "deployment/deployment.hpp"
#include "graph.hpp"

namespace tocsin::check {

/// Whether each host's way over the link has one owner, the component `link_router`. Errors: a host
/// with several; a host with one whose peer in this file has none, for they do not hear each other;
/// a host that has peers and components with link topics, and no router. Peers are matched by
/// address; those that are not in the file are not judged.
[[nodiscard]] std::vector<Finding> examine_routers(const deployment::Deployment& deployment,
                                                   const Graph& graph);

}  // namespace tocsin::check
