// SPDX-License-Identifier: Apache-2.0
#include "action_goal.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <random>
#include <utility>

#include "action_text.hpp"
#include "command_line/stop_signal.hpp"
#include "foundation/error.hpp"
#include "foundation/ros_names.hpp"
#include "foundation/yaml_sources.hpp"
#include "message_yaml.hpp"
#include "ros_idl/action_msgs.hpp"
#include "running_names.hpp"
#include "runtime/middleware/action_ports.hpp"

namespace tocsin::topic_tool {
namespace {

constexpr Duration poll_period = std::chrono::milliseconds(50);
constexpr std::size_t encapsulation_bytes = 4;
using CancelRequest = action_msgs::srv::CancelGoal_Request;
using CancelResponse = action_msgs::srv::CancelGoal_Response;

const TypeInfo& part(const std::string& type, const char* suffix) {
  return known_type(wire_type(type + suffix));
}

/// Finds a number at the top of a message.
class NumberFinder final : public FieldVisitor {
 public:
  explicit NumberFinder(std::string name) : name_(std::move(name)) {}
  void number(const char*, double) override {}
  void integer(const char* name, std::int64_t value) override {
    if (depth_ == 0 && name == name_) found = value;
  }
  void text(const char*, const std::string&) override {}
  void bytes(const char*, const std::uint8_t*, std::size_t) override {}
  void begin_struct(const char*) override { ++depth_; }
  void end_struct() override { --depth_; }
  void begin_list(const char*, std::size_t) override { ++depth_; }
  void end_list() override { --depth_; }
  std::int64_t found = 0;

 private:
  const std::string name_;
  int depth_ = 0;
};

GoalId random_id() {
  std::random_device random;
  GoalId id;
  std::generate(id.begin(), id.end(), [&] { return static_cast<std::uint8_t>(random()); });
  return to_uuid(id);
}

YAML::Node id_node(const GoalId& id) {
  YAML::Node node;
  for (const std::uint8_t byte : id) node["uuid"].push_back(static_cast<int>(byte));
  return node;
}

/// What is asked with the id of a goal alone.
std::shared_ptr<void> with_id(const TypeInfo& type, const GoalId& id) {
  YAML::Node node;
  node["goal_id"] = id_node(id);
  return from_yaml(type, YAML::Dump(node));
}

/// A goal that is on its way, with all that is needed to hear of it.
class SentGoal {
 public:
  SentGoal(const TopicSession& session, const KnownAction& types, const GoalOptions& options)
      : session_(session),
        types_(types),
        options_(options),
        send_(session.graph(), {options.action + "/_action/send_goal", &types.send_goal_request,
                                &types.send_goal_response}),
        result_(session.graph(), {options.action + "/_action/get_result", &types.get_result_request,
                                  &types.get_result_response}),
        cancel_(session.graph(), {options.action + "/_action/cancel_goal",
                                  &type_info<CancelRequest>(), &type_info<CancelResponse>()}),
        feedback_(session.graph(),
                  {wire_topic(options.action + "/_action/feedback"), types.feedback.name, true}) {}

  GoalState run() {
    const auto request = goal_request(types_, id_, options_.goal);
    std::printf("Waiting for an action server to become available...\n");
    std::fflush(stdout);
    require_server();
    std::printf("Sending goal:\n     %s\n",
                yaml_in(types_.send_goal_request, request.get(), "goal").c_str());
    const auto answer = send_.call(request, options_.patience);
    if (number_in(types_.send_goal_response, answer.get(), "accepted") == 0) {
      std::printf("Goal was rejected.\n%s", reason_of_rejection().c_str());
      return GoalState::unknown;
    }
    std::printf("Goal accepted with ID: %s\n\n", goal_text(id_).c_str());
    std::fflush(stdout);
    const auto end = wait_for_result();
    return end ? told(*end) : cancel();
  }

 private:
  /// Throws EnvironmentError with the actions that are like the one that nobody serves.
  void require_server() {
    try {
      for (ServiceCaller* const one : {&send_, &result_, &cancel_}) one->require(options_.patience);
    } catch (const EnvironmentError& error) {
      const auto actions = keys_of(actions_in(session_.ends(), session_.graph().nodes()));
      throw EnvironmentError(error.what() + suggested_names(actions, options_.action));
    }
  }
  /// What our servers tell in the result of such a goal; empty: nothing, as others.
  std::string reason_of_rejection() {
    const TypeInfo& type = types_.get_result_response;
    const auto number = result_.send(with_id(types_.get_result_request, id_));
    std::shared_ptr<const void> answer;
    for (Duration waited{0}; number && !answer && waited < reason_wait; waited += poll_period) {
      (void)feedback_.take(poll_period);
      answer = result_.reply(*number);
    }
    if (!answer) return "";
    const std::string told = yaml_in(type, answer.get(), "result");
    const std::string nothing = yaml_in(type, type.create().get(), "result");
    return told == nothing ? "" : "Result:\n    " + told + "\n";
  }
  /// Nothing: Ctrl-C was pressed.
  std::optional<std::shared_ptr<const void>> wait_for_result() {
    const auto number = result_.send(with_id(types_.get_result_request, id_));
    if (!number) throw EnvironmentError("action " + options_.action + ": its server is gone");
    while (!is_stopped()) {
      if (const auto sample = feedback_.take(poll_period)) tell(*sample);
      if (auto answer = result_.reply(*number)) {
        while (const auto sample = feedback_.take(Duration{1})) tell(*sample);
        return answer;
      }
    }
    return std::nullopt;
  }
  void tell(const RawSample& sample) {
    const auto& bytes = *sample.bytes;
    const bool of_this = bytes.size() >= encapsulation_bytes + id_.size() &&
                         std::equal(id_.begin(), id_.end(), bytes.begin() + encapsulation_bytes);
    const auto message = types_.feedback.create();
    if (!options_.feedback || !of_this ||
        !types_.feedback.deserialize(bytes.data(), bytes.size(), message.get())) {
      return;
    }
    std::printf("Feedback:\n    %s\n", yaml_in(types_.feedback, message.get(), "feedback").c_str());
    std::fflush(stdout);
  }
  GoalState told(const std::shared_ptr<const void>& answer) {
    const auto state =
        static_cast<GoalState>(number_in(types_.get_result_response, answer.get(), "status"));
    std::printf("Result:\n    %s\nGoal finished with status: %s\n",
                yaml_in(types_.get_result_response, answer.get(), "result").c_str(),
                to_text(state));
    return state;
  }
  GoalState cancel() {
    std::printf("Canceling goal...\n");
    std::fflush(stdout);
    auto request = std::make_shared<CancelRequest>();
    request->goal_info().goal_id().uuid(id_);
    cancel_.outlast_signals();
    const auto answer = std::static_pointer_cast<const CancelResponse>(
        cancel_.call(std::static_pointer_cast<const void>(request), options_.patience));
    if (answer->goals_canceling().empty()) throw EnvironmentError("Failed to cancel goal");
    std::printf("Goal canceled.\n");
    return GoalState::canceled;
  }

  const TopicSession& session_;
  const KnownAction& types_;
  const GoalOptions& options_;
  const GoalId id_ = random_id();
  ServiceCaller send_;
  ServiceCaller result_;
  ServiceCaller cancel_;
  SampleQueue feedback_;
};

}  // namespace

KnownAction::KnownAction(const std::string& type)
    : goal(part(type, "_Goal")),
      send_goal_request(part(type, "_SendGoal_Request")),
      send_goal_response(part(type, "_SendGoal_Response")),
      get_result_request(part(type, "_GetResult_Request")),
      get_result_response(part(type, "_GetResult_Response")),
      feedback(part(type, "_FeedbackMessage")) {}

std::int64_t number_in(const TypeInfo& type, const void* message, const char* name) {
  NumberFinder finder(name);
  type.visit(message, finder);
  return finder.found;
}

std::string yaml_in(const TypeInfo& type, const void* message, const char* field) {
  EchoOptions options;
  options.field = field;
  options.longest = 0;
  return to_yaml(type, message, options);
}

std::shared_ptr<void> goal_request(const KnownAction& types, const GoalId& id,
                                   const std::string& goal) {
  (void)from_yaml(types.goal, goal);  // whose errors name the fields of the goal
  YamlSources sources;
  YAML::Node request;
  request["goal_id"] = id_node(id);
  request["goal"] = sources.parse(goal.empty() ? "{}" : goal, "goal");
  return from_yaml(types.send_goal_request, YAML::Dump(request));
}

GoalState send_goal(const TopicSession& session, const KnownAction& types,
                    const GoalOptions& options) {
  return SentGoal(session, types, options).run();
}

}  // namespace tocsin::topic_tool
