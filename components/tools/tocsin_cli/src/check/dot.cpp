// SPDX-License-Identifier: Apache-2.0
#include "dot.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "command_line/run_to_end.hpp"
#include "foundation/error.hpp"

namespace tocsin::check {
namespace {

std::string quoted(const std::string& text) { return '"' + text + '"'; }

bool is_observer(const Node& node) {
  return std::none_of(node.ports.begin(), node.ports.end(),
                      [](const Port& port) { return port.writes; });
}

Graph without_observers(Graph graph) {
  graph.erase(std::remove_if(graph.begin(), graph.end(), is_observer), graph.end());
  return graph;
}

/// One oval: a host topic is another topic on each host.
struct Oval {
  std::string label;
  std::string host;  ///< empty: between the hosts
  std::vector<std::string> writers;
  std::vector<std::string> readers;
};

std::map<std::string, Oval> ovals_of(const Graph& graph) {
  std::map<std::string, Oval> ovals;
  for (const Node& node : graph) {
    for (const Port& port : node.ports) {
      const std::string host = port.scope == Scope::link ? "" : node.host;
      Oval& oval = ovals[host + ":" + port.topic];
      oval.label = port.topic;
      oval.host = host;
      (port.writes ? oval.writers : oval.readers).push_back(node.path());
    }
  }
  return ovals;
}

class Drawing {
 public:
  Drawing(const Graph& graph, bool all) : graph_(graph), ovals_(ovals_of(graph)), all_(all) {}

  std::string text() {
    out_ << "digraph deployment {\n  rankdir=LR; compound=true;\n"
            "  node [shape=box, style=\"rounded,filled\", fillcolor=white, "
            "fontname=\"sans-serif\", fontsize=11];\n"
            "  edge [color=\"#555555\"];\n";
    std::set<std::string> hosts;
    for (const Node& node : graph_) {
      if (hosts.insert(node.host).second) draw_host(node.host, node.role);
    }
    draw_ovals("");
    out_ << "}\n";
    return out_.str();
  }

 private:
  void draw_host(const std::string& host, Role role) {
    out_ << "  subgraph " << quoted("cluster_" + host)
         << " {\n    label=" << quoted(host + " (role " + to_string(role) + ")")
         << "; fontname=\"sans-serif\"; style=filled; color=\"#e8eef4\";\n";
    std::set<std::string> containers;
    for (const Node& node : graph_) {
      if (node.host == host && containers.insert(node.container).second) {
        draw_container(host, node.container);
      }
    }
    draw_ovals(host);
    out_ << "  }\n";
  }

  void draw_container(const std::string& host, const std::string& container) {
    out_ << "    subgraph " << quoted("cluster_" + host + "/" + container)
         << " {\n      label=" << quoted(container) << "; style=filled; color=\"#cfdbe6\";\n";
    for (const Node& node : graph_) {
      if (node.host != host || node.container != container) continue;
      out_ << "      " << quoted(node.path()) << " [label=" << quoted(node.name) << "];\n";
    }
    out_ << "    }\n";
  }

  void draw_ovals(const std::string& host) {
    for (const auto& [id, oval] : ovals_) {
      if (oval.host != host || (!all_ && (oval.readers.empty() || oval.writers.empty()))) continue;
      out_ << "    " << quoted(id) << " [label=" << quoted(oval.label) << ", shape=ellipse"
           << (host.empty() ? ", fillcolor=\"#f7d6d0\"" : "") << "];\n";
      for (const std::string& writer : oval.writers) {
        out_ << "    " << quoted(writer) << " -> " << quoted(id) << ";\n";
      }
      for (const std::string& reader : oval.readers) {
        out_ << "    " << quoted(id) << " -> " << quoted(reader) << ";\n";
      }
    }
  }

  const Graph& graph_;
  const std::map<std::string, Oval> ovals_;
  const bool all_;
  std::ostringstream out_;
};

}  // namespace

std::string to_dot(const Graph& graph, bool all) {
  const Graph shown = all ? graph : without_observers(graph);
  return Drawing(shown, all).text();
}

void draw_svg(const std::string& dot, const std::string& path) {
  Ended drawn;
  try {
    drawn = run_to_end({"dot", "-Tsvg", "-o", path}, {dot, ""});
  } catch (const EnvironmentError& error) {
    throw EnvironmentError(path + ": is not drawn without dot (package graphviz): " + error.what());
  }
  if (drawn.code != 0) throw EnvironmentError(path + ": dot could not draw it: " + drawn.output);
}

}  // namespace tocsin::check
