// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/action_ports.hpp"

#include <cassert>
#include <cstring>
#include <utility>

#include "idl_support/topic_registry.hpp"
#include "runtime/middleware/ros_stamp.hpp"

namespace tocsin {
namespace {

constexpr Duration kept = std::chrono::seconds(10);  // rcl_action's result_timeout
constexpr std::int64_t second = 1'000'000'000;
using StatusArray = action_msgs::msg::GoalStatusArray;

std::int64_t ns_of(const builtin_interfaces::msg::Time& stamp) {
  return stamp.sec() * second + stamp.nanosec();
}

action_msgs::msg::GoalInfo info_of(const KnownGoal& goal) {
  action_msgs::msg::GoalInfo info;
  info.goal_id().uuid(goal.id);
  info.stamp(ros_stamp(goal.accepted_ns));
  return info;
}

}  // namespace

std::string action_end(const std::string& action, const char* end) {
  return action + "/_action/" + end;
}

TopicInfo action_topic(const std::string& action, const char* end, const char* qos) {
  return make_topic_info(action_end(action, end), qos, Scope::host);
}

ActionServerPort::ActionServerPort(Component& owner, const std::string& action)
    : owner_(owner),
      goals_(kept),
      cancel_(owner, action_end(action, "cancel_goal"), owner.node()),
      status_(
          owner.bus().advertise({action_topic(action, "status", "state"), &type_info<StatusArray>(),
                                 Writers::needed, "", owner.node()})) {}

std::vector<GoalId> ActionServerPort::serve_cancels(Time now) {
  while (const auto call = cancel_.take()) {
    const auto& wanted = call->request->goal_info();
    const CancelAnswer answer =
        goals_.cancel({wanted.goal_id().uuid(), ns_of(wanted.stamp())}, now);
    CancelGoal::Response response;
    response.return_code(static_cast<std::int8_t>(answer.code));
    for (const KnownGoal& goal : answer.canceling) {
      response.goals_canceling().push_back(info_of(goal));
    }
    cancel_.reply(call->id, std::move(response));
    if (!answer.canceling.empty()) tell_status();
  }
  return goals_.forget(now);
}

std::optional<std::int64_t> ActionServerPort::take_up(const GoalId& id, Time now) {
  const std::int64_t accepted_ns = owner_.bus().wall_ns(now);
  if (!goals_.add(id, accepted_ns)) return std::nullopt;
  apply(id, GoalEvent::execute, now);
  return accepted_ns;
}

void ActionServerPort::apply(const GoalId& id, GoalEvent event, Time now) {
  const bool allowed = goals_.apply(id, event, now);
  assert(allowed);
  (void)allowed;
  tell_status();
}

void ActionServerPort::tell_status() {
  auto message = std::make_shared<StatusArray>();
  for (const KnownGoal& goal : goals_.all()) {
    action_msgs::msg::GoalStatus one;
    one.goal_info(info_of(goal));
    one.status(static_cast<std::int8_t>(goal.state));
    message->status_list().push_back(std::move(one));
  }
  (void)status_->write(message);  // the next change says it again
}

GoalIds::GoalIds(Component& owner) {
  const auto ns = static_cast<std::uint64_t>(owner.bus().wall_ns(owner.bus().now()));
  std::vector<std::uint32_t> seeds{static_cast<std::uint32_t>(ns),
                                   static_cast<std::uint32_t>(ns >> 32U)};
  for (const char letter : owner.name()) seeds.push_back(static_cast<unsigned char>(letter));
  std::seed_seq sequence(seeds.begin(), seeds.end());
  random_.seed(sequence);
}

GoalId GoalIds::next() {
  const std::array<std::uint64_t, 2> random{random_(), random_()};
  GoalId id;
  std::memcpy(id.data(), random.data(), id.size());
  return to_uuid(id);
}

}  // namespace tocsin
