// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>
#include <utility>

namespace tocsin {

/// The types of an action as rosidl makes them of an .action file: two services and the message of
/// its feedback, each with the id of the goal.
template <class SendGoalRequestType, class SendGoalResponseType, class GetResultRequestType,
          class GetResultResponseType, class FeedbackMessageType>
struct ActionTypes {
  using SendGoalRequest = SendGoalRequestType;
  using SendGoalResponse = SendGoalResponseType;
  using GetResultRequest = GetResultRequestType;
  using GetResultResponse = GetResultResponseType;
  using FeedbackMessage = FeedbackMessageType;
  using Goal = std::decay_t<decltype(std::declval<SendGoalRequest&>().goal())>;
  using Result = std::decay_t<decltype(std::declval<GetResultResponse&>().result())>;
  using Feedback = std::decay_t<decltype(std::declval<FeedbackMessage&>().feedback())>;
};

}  // namespace tocsin
