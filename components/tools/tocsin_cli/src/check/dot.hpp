// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "graph.hpp"

namespace tocsin::check {

/// The graph in the language of Graphviz: hosts and containers as boxes, components as nodes,
/// topics as labelled ovals; topics that cross the radio are red. Unless `all`, components that
/// write nothing (recorders, views), the gates, and topics without a reader are left out.
[[nodiscard]] std::string to_dot(const Graph& graph, bool all);

/// Draws the text of to_dot to the file `path`. Throws EnvironmentError when dot is not there
/// (package graphviz) or cannot do it.
void draw_svg(const std::string& dot, const std::string& path);

}  // namespace tocsin::check
