// SPDX-License-Identifier: Apache-2.0
// `tocsin lifecycle` as a user runs it, on real DDS, beside a node that goes through two states.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "command_line/run_to_end.hpp"
#include "runtime/middleware/ros_services.hpp"
#include "runtime/service_port.hpp"
#include "ticked_neighbour.hpp"

namespace tocsin::topic_tool {
namespace {

using ::testing::HasSubstr;
namespace service = lifecycle_service;
using State = lifecycle_msgs::msg::State;
using Way = lifecycle_msgs::msg::TransitionDescription;

constexpr int domain = 129;

State named(bool active) {
  State state;
  state.id(active ? 3 : 2);
  state.label(active ? "active" : "inactive");
  return state;
}

/// Answers by hand what a container answers for its components.
class Lamp : public Component {
 public:
  explicit Lamp(Context& context) : Component(context) {}
  void tick(Time) override {
    while (auto call = state_.take()) {
      service::GetState::Response response;
      response.current_state(named(active_));
      state_.reply(call->id, response);
    }
    while (auto call = ways_.take()) {
      service::GetAvailableTransitions::Response response;
      response.available_transitions({way()});
      ways_.reply(call->id, response);
    }
    while (auto call = change_.take()) {
      service::ChangeState::Response response;
      response.success(call->request->transition().id() == way().transition().id());
      if (response.success()) active_ = !active_;
      change_.reply(call->id, response);
    }
  }

 private:
  [[nodiscard]] Way way() const {
    Way way;
    way.transition().id(active_ ? 4 : 3);
    way.transition().label(active_ ? "deactivate" : "activate");
    way.start_state(named(active_));
    way.goal_state().label(active_ ? "deactivating" : "activating");
    return way;
  }
  bool active_ = true;
  Server<service::GetState> state_{*this};
  Server<service::GetAvailableTransitions> ways_{*this};
  Server<service::ChangeState> change_{*this};
};

Ended lifecycle(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), LIFECYCLE_PROGRAM);
  arguments.insert(arguments.end(), {"--domain", std::to_string(domain)});
  return run_to_end(arguments);
}

TEST(LifecycleProgram, ShowsStatesAndLeadsANodeToAnother) {
  const TickedNeighbour<Lamp> neighbour(domain, "lamp");
  EXPECT_EQ(lifecycle({"nodes"}).output, "/lamp\n");
  EXPECT_EQ(lifecycle({"get"}).output, "/lamp: active [3]\n");
  EXPECT_EQ(lifecycle({"list", "/lamp"}).output,
            "- deactivate [4]\n\tStart: active\n\tGoal: deactivating\n");
  EXPECT_EQ(lifecycle({"set", "/lamp", "deactivate"}).output, "Transitioning successful\n");
  EXPECT_EQ(lifecycle({"get", "lamp"}).output, "inactive [2]\n");
  const Ended unknown = lifecycle({"set", "/lamp", "deactivate"});
  EXPECT_EQ(unknown.code, 1);
  EXPECT_EQ(unknown.output, "Unknown transition requested, available ones are:\n- activate [3]\n");
}

TEST(LifecycleProgram, SaysInOneLineThatANodeHasNone) {
  const Ended sut = lifecycle({"get", "/nobody", "--timeout", "0.3"});
  EXPECT_EQ(sut.code, 1);
  EXPECT_THAT(sut.output, HasSubstr("service /nobody/get_state: nobody serves it\n"));
}

}  // namespace
}  // namespace tocsin::topic_tool
