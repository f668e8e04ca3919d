// SPDX-License-Identifier: Apache-2.0
#include "idl_support/action_types.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tocsin {
namespace {

template <class Part>
struct Holder {
  Part& goal() { return part; }
  Part& result() { return part; }
  Part& feedback() { return part; }
  Part part;
};

TEST(ActionTypes, PartsAreThoseWithinTheMessages) {
  using Action = ActionTypes<Holder<int>, bool, char, Holder<double>, Holder<std::string>>;
  static_assert(std::is_same_v<Action::Goal, int>);
  static_assert(std::is_same_v<Action::Result, double>);
  static_assert(std::is_same_v<Action::Feedback, std::string>);
  EXPECT_TRUE((std::is_same_v<Action::SendGoalRequest, Holder<int>>));
  EXPECT_TRUE((std::is_same_v<Action::GetResultRequest, char>));
}

}  // namespace
}  // namespace tocsin
