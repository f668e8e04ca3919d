// SPDX-License-Identifier: Apache-2.0
// tocsin lifecycle nodes | get | set | list, as `ros2 lifecycle` has them.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "command_line/command.hpp"
#include "commands.hpp"
#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/ros_names.hpp"
#include "lifecycle_text.hpp"
#include "running_names.hpp"
#include "runtime/middleware/ros_services.hpp"
#include "topic_session.hpp"

namespace tocsin::topic_tool {
namespace {

/// Our containers make the services of a node when they are called.
constexpr Duration until_made = std::chrono::seconds(1);

struct LifecycleOptions : SessionOptions {
  double timeout_s = 5;
  std::string node;
  std::string transition;
  bool all = false;
  bool count = false;
};

template <class Service>
std::shared_ptr<const typename Service::Response> ask(const LifecycleOptions& options,
                                                      const TopicSession& session,
                                                      const std::string& node,
                                                      typename Service::Request request = {}) {
  return call_node<Service>(session.graph(), absolute(node), std::move(request),
                            seconds(options.timeout_s));
}

/// Those that say in which state they are, by path.
std::vector<std::string> lifecycle_nodes(const LifecycleOptions& options,
                                         const TopicSession& session) {
  using Clock = std::chrono::steady_clock;
  (void)session.ends();
  std::map<std::string, std::unique_ptr<ServiceCaller>> callers;
  for (const GraphNode& node : session.graph().nodes()) {
    const bool hidden = node.name.empty() || node.name[0] == '_';
    if (hidden && !options.all) continue;
    callers[node.path()] = std::make_unique<ServiceCaller>(
        session.graph(),
        ServiceEndpoint{lifecycle_service::GetState::name,
                        &type_info<lifecycle_service::GetState::Request>(),
                        &type_info<lifecycle_service::GetState::Response>(), node.path()});
  }
  const auto due = Clock::now() + until_made;
  std::vector<std::string> paths;
  for (const auto& [path, caller] : callers) {
    const Duration left = std::max(due - Clock::now(), Duration{1});
    if (caller->wait_for_server(left)) paths.push_back(path);
  }
  return paths;
}

int nodes(const LifecycleOptions& options) {
  const TopicSession session(options);
  const auto all = lifecycle_nodes(options, session);
  if (options.count) {
    std::printf("%zu\n", all.size());
    return 0;
  }
  for (const std::string& one : all) std::printf("%s\n", printable(one).c_str());
  return 0;
}

int get(const LifecycleOptions& options) {
  const TopicSession session(options);
  if (!options.node.empty()) {
    const auto response = ask<lifecycle_service::GetState>(options, session, options.node);
    std::printf("%s\n", state_text(response->current_state()).c_str());
    return 0;
  }
  for (const std::string& node : lifecycle_nodes(options, session)) {
    const auto response = ask<lifecycle_service::GetState>(options, session, node);
    std::printf("%s: %s\n", printable(node).c_str(), state_text(response->current_state()).c_str());
  }
  return 0;
}

int set(const LifecycleOptions& options) {
  const TopicSession session(options);
  const auto ways = ask<lifecycle_service::GetAvailableTransitions>(options, session, options.node)
                        ->available_transitions();
  const auto transition = chosen(ways, options.transition);
  if (!transition) {
    std::fputs(unknown_text(ways).c_str(), stderr);
    return 1;
  }
  lifecycle_service::ChangeState::Request request;
  request.transition(*transition);
  const bool done =
      ask<lifecycle_service::ChangeState>(options, session, options.node, request)->success();
  std::fputs(done ? "Transitioning successful\n" : "Transitioning failed\n",
             done ? stdout : stderr);
  return done ? 0 : 1;
}

int list(const LifecycleOptions& options) {
  const TopicSession session(options);
  const Transitions ways =
      options.all ? ask<lifecycle_service::GetTransitionGraph>(options, session, options.node)
                        ->available_transitions()
                  : ask<lifecycle_service::GetAvailableTransitions>(options, session, options.node)
                        ->available_transitions();
  std::fputs(transitions_text(ways).c_str(), stdout);
  return 0;
}

CLI::App* declare_verb(Verbs& verbs, LifecycleOptions& options, const char* name, const char* text,
                       int (*body)(const LifecycleOptions&)) {
  CLI::App* const sub = add_verb(verbs, options, name, text, body);
  declare_timeout(*sub, options.timeout_s);
  return sub;
}

void declare(Verbs& verbs, LifecycleOptions& options) {
  const char* const of = "its name, with its namespace";
  CLI::App* const all = declare_verb(verbs, options, "nodes", "nodes that have a lifecycle", nodes);
  all->add_flag("-a,--all", options.all, "those that begin with _, too");
  all->add_flag("-c,--count-nodes", options.count, "how many there are");
  declare_verb(verbs, options, "get", "the state of a node, or of all", get)
      ->add_option("node_name", options.node, of);
  CLI::App* const change =
      declare_verb(verbs, options, "set", "leads a node into another state", set);
  change->add_option("node_name", options.node, of)->required();
  change->add_option("transition", options.transition, "see list: its name or its number")
      ->required();
  CLI::App* const ways =
      declare_verb(verbs, options, "list", "what leads out of a node's state", list);
  ways->add_option("node_name", options.node, of)->required();
  ways->add_flag("-a,--all", options.all, "out of every state");
}

}  // namespace

int run_lifecycle(int argc, char** argv) {
  return run_verbs<LifecycleOptions>(
      argc, argv, "tocsin lifecycle",
      "States of nodes of a running host, ours and those of other ROS 2 programs there.", declare);
}

}  // namespace tocsin::topic_tool
