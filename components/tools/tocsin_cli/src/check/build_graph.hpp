// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "deployment/deployment.hpp"
#include "graph.hpp"

namespace tocsin::check {

/// The components of a deployment with the ports that they make; those that cannot be built are
/// findings. Builds every component on a bus that only records, and destroys it again: it is never
/// ticked. Files that components make in their constructors appear in `run_dir`.
struct BuiltGraph {
  Graph graph;
  std::vector<Finding> findings;
};
[[nodiscard]] BuiltGraph build_graph(const deployment::Deployment& deployment);

}  // namespace tocsin::check
