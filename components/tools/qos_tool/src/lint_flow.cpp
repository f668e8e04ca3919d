// SPDX-License-Identifier: Apache-2.0
#include "lint_flow.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace tocsin::qos_tool {
namespace {

constexpr double longest_period_s = 0.05;

/// A profile that sends through a flow controller.
struct Member {
  std::string name;
  const QosProfile* profile;
  bool is_stream;
};

std::vector<Member> members_of(const LintInput& input, const std::string& controller) {
  std::vector<Member> members;
  for (const auto& [name, profile] : input.profiles) {
    if (profile.flow_controller != controller) continue;
    const std::string& of = name;
    const bool is_stream = std::any_of(
        input.topics.begin(), input.topics.end(),
        [&of](const LintTopic& topic) { return topic.profile == of && topic.is_stream; });
    members.push_back({name, &profile, is_stream});
  }
  return members;
}

/// The scheduler sends in the order of arrival, or in turns: a stream stands before a command.
std::string behind_stream(const Member& stream, const Member& other,
                          const FlowController& controller) {
  if (controller.scheduler == "fifo" || controller.scheduler == "round_robin") {
    return fmt::format(
        "{} waits behind what {} has begun (measured with 2.4 MB of bulk: fifo 1.7 s, round_robin "
        "0.1 to 0.5 s, high_priority with a period of 0.01 s 3 ms); use high_priority",
        other.name, stream.name, controller.scheduler);
  }
  if (stream.profile->priority <= other.profile->priority) {
    return fmt::format(
        "the stream {} has priority {} and {} has {}: the stream goes first, and "
        "what comes after it may never go; -10 is the first",
        stream.name, stream.profile->priority, other.name, other.profile->priority);
  }
  return "";
}

std::string behind_any_stream(const std::vector<Member>& members,
                              const FlowController& controller) {
  for (const Member& stream : members) {
    if (!stream.is_stream) continue;
    for (const Member& other : members) {
      if (other.is_stream) continue;
      const std::string reason = behind_stream(stream, other, controller);
      if (!reason.empty()) return reason;
    }
  }
  return "";
}

std::string too_much_reserved(const std::vector<Member>& members) {
  int percent = 0;
  for (const Member& one : members) percent += one.profile->bandwidth_reservation_percent;
  return percent > 100 ? fmt::format("{} % of it are reserved in all", percent) : "";
}

std::string long_period(const FlowController& controller) {
  if (controller.scheduler == "fifo" || controller.period_s <= longest_period_s) return "";
  return fmt::format(
      "a writer of high priority waits up to a whole period of {} s; 0.01 s with as "
      "many bytes a second costs nothing",
      controller.period_s);
}

}  // namespace

void starving_flow(const LintInput& input, const char* rule, std::vector<Finding>& found) {
  for (const auto& [name, controller] : input.flow_controllers) {
    if (controller.max_bytes_per_period == 0) continue;  // unlimited: nobody waits
    const auto members = members_of(input, name);
    for (const std::string& reason : {behind_any_stream(members, controller),
                                      too_much_reserved(members), long_period(controller)}) {
      if (!reason.empty()) found.push_back({rule, "flow controller " + name, reason});
    }
  }
}

}  // namespace tocsin::qos_tool
