// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "idl_support/type_info.hpp"
#include "runtime/middleware/goal_table.hpp"
#include "runtime/middleware/service_caller.hpp"
#include "topic_session.hpp"

namespace tocsin::topic_tool {

/// The types of an action, by `pkg/action/Name`. Throws ConfigError when they are not known here.
struct KnownAction {
  explicit KnownAction(const std::string& type);
  const TypeInfo& goal;
  const TypeInfo& send_goal_request;
  const TypeInfo& send_goal_response;
  const TypeInfo& get_result_request;
  const TypeInfo& get_result_response;
  const TypeInfo& feedback;
};

/// A number field of a message by its name; 0 when it has none.
[[nodiscard]] std::int64_t number_in(const TypeInfo& type, const void* message, const char* name);
/// The fields of `field` of a message, as YAML.
[[nodiscard]] std::string yaml_in(const TypeInfo& type, const void* message, const char* field);
/// The message that sends a goal: its id, and the goal as YAML. Throws ConfigError.
[[nodiscard]] std::shared_ptr<void> goal_request(const KnownAction& types, const GoalId& id,
                                                 const std::string& goal);

struct GoalOptions {
  std::string action;  ///< with its slash
  std::string goal;    ///< YAML
  bool feedback = false;
  Duration patience{};  ///< for the server, and for each of its answers but the result
};

/// Sends a goal, prints what becomes of it as `ros2 action send_goal` does, and waits for its end.
/// Ctrl-C cancels it. Throws EnvironmentError when nobody serves or answers.
[[nodiscard]] GoalState send_goal(const TopicSession& session, const KnownAction& types,
                                  const GoalOptions& options);

}  // namespace tocsin::topic_tool
