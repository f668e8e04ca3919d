// SPDX-License-Identifier: Apache-2.0
// tocsin node list | info, as `ros2 node` has them.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "command_line/command.hpp"
#include "commands.hpp"
#include "foundation/error.hpp"
#include "foundation/ros_names.hpp"
#include "node_text.hpp"
#include "running_names.hpp"
#include "topic_session.hpp"

namespace tocsin::topic_tool {
namespace {

struct NodeOptions : SessionOptions {
  std::string node;
  bool hidden = false;
  NodeListOptions list;
};

int list(const NodeOptions& options) {
  const TopicSession session(options);
  (void)session.ends();
  const auto nodes = session.graph().nodes();
  if (has_twins(nodes)) {
    std::fputs(
        "WARNING: Be aware that there are nodes in the graph that share an exact name, "
        "which can have unintended side effects.\n",
        stderr);
  }
  std::fputs(node_list_text(nodes, options.list).c_str(), stdout);
  return 0;
}

int info(const NodeOptions& options) {
  const TopicSession session(options);
  const auto ends = session.ends();
  const std::string text =
      node_info_text(ends, session.graph().nodes(), options.node, options.hidden);
  if (text.empty()) {
    throw EnvironmentError("Unable to find node '" + absolute(options.node) + "'" +
                           suggested_names(node_paths(session.graph()), absolute(options.node)));
  }
  std::fputs(text.c_str(), stdout);
  return 0;
}

void declare(Verbs& verbs, NodeOptions& options) {
  CLI::App* const all = add_verb(verbs, options, "list", "names of all nodes", list);
  all->add_flag("-a,--all", options.list.hidden, "those that begin with _, too");
  all->add_flag("-c,--count-nodes", options.list.count, "how many there are");
  CLI::App* const about =
      add_verb(verbs, options, "info", "what a node reads, writes, serves and calls", info);
  about->add_option("node", options.node, "its name, with its namespace")->required();
  about->add_flag("--include-hidden", options.hidden, "names that begin with _, too");
}

}  // namespace

int run_node(int argc, char** argv) {
  return run_verbs<NodeOptions>(
      argc, argv, "tocsin node",
      "Nodes of a running host, ours and those of other ROS 2 programs there.", declare);
}

}  // namespace tocsin::topic_tool
