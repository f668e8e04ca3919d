// SPDX-License-Identifier: Apache-2.0
// The action example_interfaces/action/Fibonacci as its bytes stand on the wire.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "fast_dds_service.hpp"
#include "idl_support/action_types.hpp"
#include "ros_idl/example_interfaces.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "runtime/middleware/host_graph.hpp"

namespace tocsin::interop {

using Bytes = std::vector<std::uint8_t>;
namespace wire = example_interfaces::action;

inline BusOptions host(int domain, const char* name) {
  BusOptions options;
  options.name = name;
  options.host_domain = domain;
  return options;
}

struct Fibonacci
    : ActionTypes<wire::Fibonacci_SendGoal_Request, wire::Fibonacci_SendGoal_Response,
                  wire::Fibonacci_GetResult_Request, wire::Fibonacci_GetResult_Response,
                  wire::Fibonacci_FeedbackMessage> {
  static constexpr const char* name = "fibonacci";
};
inline FastDdsService::Half half(const std::string& topic, const std::string& type) {
  return {topic, type};
}
inline const std::string of = "example_interfaces::action::dds_::Fibonacci_";
inline const auto goal_request =
    half("rq/fibonacci/_action/send_goalRequest", of + "SendGoal_Request_");
inline const auto goal_reply =
    half("rr/fibonacci/_action/send_goalReply", of + "SendGoal_Response_");
inline const auto result_request =
    half("rq/fibonacci/_action/get_resultRequest", of + "GetResult_Request_");
inline const auto result_reply =
    half("rr/fibonacci/_action/get_resultReply", of + "GetResult_Response_");
inline const auto cancel_request =
    half("rq/fibonacci/_action/cancel_goalRequest", "action_msgs::srv::dds_::CancelGoal_Request_");
inline const auto cancel_reply =
    half("rr/fibonacci/_action/cancel_goalReply", "action_msgs::srv::dds_::CancelGoal_Response_");
inline const RawTopic feedback_topic{"rt/fibonacci/_action/feedback", of + "FeedbackMessage_",
                                     true};
inline const RawTopic status_topic{"rt/fibonacci/_action/status",
                                   "action_msgs::msg::dds_::GoalStatusArray_", true, true};

inline const Bytes encapsulation{0, 1, 0, 0};
inline const Bytes id{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
inline const Bytes order_3{3, 0, 0, 0};

inline Bytes joined(std::initializer_list<Bytes> parts) {
  Bytes all = encapsulation;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}
inline Bytes part(const Bytes& bytes, std::size_t from, std::size_t size) {
  if (bytes.size() < from + size) return {};
  const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(from);
  return {begin, begin + static_cast<std::ptrdiff_t>(size)};
}

}  // namespace tocsin::interop
