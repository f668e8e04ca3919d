// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "graph.hpp"

namespace tocsin::check {

/// The graph in the language of Graphviz: hosts and containers as boxes, components as nodes,
/// topics as labelled ovals; topics that cross the radio are red. Unless `all`, components that
/// write nothing (recorders, views), the gates, and topics without a reader are left out.
[[nodiscard]] std::string to_dot(const Graph& graph, bool all);

}  // namespace tocsin::check
