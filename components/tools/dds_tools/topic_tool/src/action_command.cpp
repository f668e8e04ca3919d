// SPDX-License-Identifier: Apache-2.0
// tocsin action list | info | type | send_goal, as `ros2 action` has them.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <string>

#include "action_goal.hpp"
#include "action_text.hpp"
#include "command_line/command.hpp"
#include "commands.hpp"
#include "foundation/error.hpp"
#include "foundation/ros_names.hpp"
#include "running_names.hpp"
#include "topic_session.hpp"

namespace tocsin::topic_tool {
namespace {

struct ActionOptions : SessionOptions {
  double timeout_s = 5;
  std::string type;
  ActionListOptions list;
  GoalOptions goal;
};

std::map<std::string, ActionEnds> actions_of(const ActionOptions& options) {
  const TopicSession session(options);
  const auto ends = session.ends();
  return actions_in(ends, session.graph().nodes());
}

/// The one that is meant.
ActionEnds find(const ActionOptions& options) {
  const auto actions = actions_of(options);
  const auto found = actions.find(absolute(options.goal.action));
  if (found != actions.end()) return found->second;
  throw EnvironmentError("action " + absolute(options.goal.action) + " is not there" +
                         suggested_names(keys_of(actions), absolute(options.goal.action)));
}

int list(const ActionOptions& options) {
  std::fputs(action_list_text(actions_of(options), options.list).c_str(), stdout);
  return 0;
}

int info(const ActionOptions& options) {
  const ActionEnds ends = find(options);
  std::fputs(action_info_text(absolute(options.goal.action), ends, options.list).c_str(), stdout);
  return 0;
}

int type(const ActionOptions& options) {
  for (const std::string& one : find(options).types) std::printf("%s\n", one.c_str());
  return 0;
}

int send(const ActionOptions& options) {
  const KnownAction types(options.type);
  GoalOptions goal = options.goal;
  goal.action = absolute(goal.action);
  goal.patience = seconds(options.timeout_s);
  (void)goal_request(types, {}, goal.goal);  // refuses what is no such goal before it joins
  const TopicSession session(options);
  return send_goal(session, types, goal) == GoalState::succeeded ? 0 : 1;
}

void declare(Verbs& verbs, ActionOptions& options) {
  const char* const of = "its name, with or without the slash";
  CLI::App* const all =
      add_verb(verbs, options, "list", "actions that somebody serves or calls", list);
  all->add_flag("-t,--show-types", options.list.types, "with their types");
  all->add_flag("-c,--count-actions", options.list.count, "how many there are");
  CLI::App* const about =
      add_verb(verbs, options, "info", "who serves and who calls an action", info);
  about->add_option("action_name", options.goal.action, of)->required();
  about->add_flag("-t,--show-types", options.list.types, "with their types");
  about->add_flag("-c,--count", options.list.count, "only how many there are");
  add_verb(verbs, options, "type", "the type of an action", type)
      ->add_option("action_name", options.goal.action, of)
      ->required();
  CLI::App* const sent =
      add_verb(verbs, options, "send_goal", "sends a goal and waits for its end", send);
  sent->add_option("action_name", options.goal.action, of)->required();
  sent->add_option("action_type", options.type, "nav2_msgs/action/NavigateToPose")->required();
  sent->add_option("goal", options.goal.goal, "in YAML: '{order: 5}'")->required();
  sent->add_flag("-f,--feedback", options.goal.feedback, "prints how it goes, too");
  declare_timeout(*sent, options.timeout_s);
}

}  // namespace

int run_action(int argc, char** argv) {
  return run_verbs<ActionOptions>(
      argc, argv, "tocsin action",
      "Actions of a running host, ours and those of other ROS 2 programs there.", declare);
}

}  // namespace tocsin::topic_tool
