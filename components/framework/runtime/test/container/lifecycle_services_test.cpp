// SPDX-License-Identifier: Apache-2.0
// The lifecycle of the components of a container, and what it takes in, as ROS 2 asks for it.
#include "container/lifecycle_services.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "container/control_rig.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
namespace lifecycle = lifecycle_service;
namespace composition = composition_service;

class Lamp : public Component {
 public:
  struct Params {
    double brightness = 0.5;
    bool broken = false;
    template <class Visitor>
    void visit(Visitor& v) {
      live(v)("brightness", brightness, {0, 1}, "[1] of it");
      v("broken", broken, "throws when it is made");
    }
  };
  Lamp(Context& context, const Params& params) : Component(context) {
    if (params.broken) throw std::runtime_error("no bulb");
  }
  void set_parameters(const Params&) {}
  void tick(Time) override {}
};

const ComponentEntry& entry_of(const std::string& library) {
  static const ComponentEntry entry = make_component_entry<Lamp>();
  if (library != "lamp") throw ConfigError("component '" + library + "': no library");
  return entry;
}

struct TransitionEvents {
  using Message = lifecycle_msgs::msg::TransitionEvent;
  static constexpr TopicInfo info{"lamp/transition_event", "event", Scope::host};
};

class LifecycleServicesTest : public ControlRig {
 protected:
  LifecycleServicesTest() : ControlRig(entry_of) {
    add("lamp", "lamp");
    instances_.activate_all();
    start();
  }
  bool change(std::uint8_t id, const char* label = "") {
    Asker<lifecycle::ChangeState> sut(bus_, "lamp");
    lifecycle::ChangeState::Request request;
    request.transition().id(id);
    request.transition().label(label);
    const auto response = sut.ask(request);
    EXPECT_TRUE(response);
    return response && response->success();
  }
  std::string state() {
    Asker<lifecycle::GetState> sut(bus_, "lamp");
    const auto response = sut.ask({});
    return response ? response->current_state().label() : "nobody answers";
  }
  static composition::LoadNode::Request lamp(const char* name, const char* parameter,
                                             const ParameterValue& value) {
    auto request = lamp(name);
    request.parameters().resize(1);
    request.parameters()[0].name(parameter);
    request.parameters()[0].value(ros_value(value));
    return request;
  }
  static composition::LoadNode::Request lamp(const char* name) {
    composition::LoadNode::Request request;
    request.package_name("lamps");
    request.plugin_name("tocsin::lamp");
    request.node_name(name);
    return request;
  }
  composition::LoadNode::Response load(const composition::LoadNode::Request& request) {
    Asker<composition::LoadNode> sut(bus_, "drive_container");
    const auto response = sut.ask(request);
    EXPECT_TRUE(response);
    return response ? *response : composition::LoadNode::Response();
  }
};

TEST_F(LifecycleServicesTest, ANodeIsLedThroughItsStates) {
  EXPECT_EQ(state(), "active");
  EXPECT_TRUE(change(4));
  EXPECT_EQ(state(), "inactive");
  EXPECT_TRUE(change(0, "cleanup"));
  EXPECT_EQ(state(), "unconfigured");
  EXPECT_TRUE(change(1));
  EXPECT_TRUE(change(3));
  EXPECT_EQ(state(), "active");
  EXPECT_TRUE(change(7));
  EXPECT_EQ(state(), "finalized");
}

TEST_F(LifecycleServicesTest, WhatIsNotAllowedChangesNothing) {
  EXPECT_FALSE(change(1));
  EXPECT_FALSE(change(0, "fly"));
  EXPECT_EQ(state(), "active");
}

TEST_F(LifecycleServicesTest, StatesAndTransitionsAreListed) {
  Asker<lifecycle::GetAvailableStates> states(bus_, "lamp");
  EXPECT_EQ(states.ask({})->available_states().size(), 11U);
  Asker<lifecycle::GetAvailableTransitions> ways(bus_, "lamp");
  const auto out = ways.ask({})->available_transitions();
  ASSERT_EQ(out.size(), 2U);
  EXPECT_EQ(out[0].transition().label(), "deactivate");
  Asker<lifecycle::GetTransitionGraph> graph(bus_, "lamp");
  EXPECT_EQ(graph.ask({})->available_transitions().size(), 18U);
}

TEST_F(LifecycleServicesTest, ChangesAreTold) {
  SimReader<TransitionEvents> events(bus_);
  EXPECT_TRUE(change(4));
  auto told = events.take();
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[1].goal_state().label(), "inactive");
  EXPECT_GT(told[1].timestamp(), 0U);
  EXPECT_TRUE(change(3));
  told = events.take();
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[1].goal_state().label(), "active");
}

TEST_F(LifecycleServicesTest, AComponentIsLoadedWithItsParametersListedAndUnloaded) {
  const auto loaded = load(lamp("desk_lamp", "brightness", 0.75));
  EXPECT_TRUE(loaded.success()) << loaded.error_message();
  EXPECT_EQ(loaded.full_node_name(), "/desk_lamp");
  Asker<composition::ListNodes> list(bus_, "drive_container");
  EXPECT_THAT(list.ask({})->full_node_names(), ElementsAre("/lamp", "/desk_lamp"));
  EXPECT_EQ(list.ask({})->unique_ids().back(), loaded.unique_id());
  EXPECT_EQ(instances_.parameters(instances_.all().back())[0].value, ParameterValue(0.75));
  Asker<composition::UnloadNode> unload(bus_, "drive_container");
  composition::UnloadNode::Request out;
  out.unique_id(loaded.unique_id());
  EXPECT_TRUE(unload.ask(out)->success());
  EXPECT_THAT(list.ask({})->full_node_names(), ElementsAre("/lamp"));
  const auto again = unload.ask(out);
  EXPECT_FALSE(again->success());
  EXPECT_THAT(again->error_message(), HasSubstr("No node found with unique_id: "));
}

TEST_F(LifecycleServicesTest, WhatCannotBeLoadedIsRefusedWithItsReason) {
  EXPECT_THAT(load(lamp("lamp")).error_message(), HasSubstr("two nodes of one name"));
  auto unknown = lamp("other");
  unknown.plugin_name("toaster");
  EXPECT_THAT(load(unknown).error_message(), HasSubstr("component 'toaster': no library"));
  auto renamed = lamp("other");
  renamed.remap_rules({"a:=b"});
  EXPECT_THAT(load(renamed).error_message(), HasSubstr("remap_rules"));
  auto elsewhere = lamp("other");
  elsewhere.node_namespace("/moon");
  EXPECT_THAT(load(elsewhere).error_message(), HasSubstr("/moon"));
  auto unset = lamp("other");
  unset.parameters().resize(1);
  unset.parameters()[0].name("brightness");
  EXPECT_THAT(load(unset).error_message(), HasSubstr("brightness: has no value"));
  EXPECT_EQ(instances_.all().size(), 1U);
}

TEST_F(LifecycleServicesTest, OneThatThrowsWhenItIsMadeIsThereInTheStateError) {
  const auto response = load(lamp("dark", "broken", true));
  EXPECT_FALSE(response.success());
  EXPECT_THAT(response.error_message(), HasSubstr("no bulb"));
  ASSERT_EQ(instances_.all().size(), 2U);
  EXPECT_EQ(instances_.all().back().state, LifecycleState::error);
}

TEST(LoadReading, TakesTheNameOfTheComponentWhereNoneIsGiven) {
  composition::LoadNode::Request request;
  request.plugin_name("navigator");
  request.node_namespace("/uxv");
  const auto reading = read_load(request, "uxv");
  ASSERT_TRUE(reading.order) << reading.fault;
  EXPECT_EQ(reading.order->library, "navigator");
  EXPECT_EQ(reading.order->name, "navigator");
}

}  // namespace
}  // namespace tocsin
