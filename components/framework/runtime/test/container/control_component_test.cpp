// SPDX-License-Identifier: Apache-2.0
#include "container/control_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "container/node_asker.hpp"
#include "foundation/error.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using State = tocsin_msgs::msg::ContainerState;

class Idle : public Component {
 public:
  struct Params {
    template <class Visitor>
    void visit(Visitor&) {}
  };
  Idle(Context& context, const Params&) : Component(context) {}
  void tick(Time) override {}
};

const ComponentEntry& entry_of(const std::string& library) {
  static const ComponentEntry entry = make_component_entry<Idle>();
  if (library != "idle") throw ConfigError("component '" + library + "': no library");
  return entry;
}

class NoTicker : public Ticker {
 public:
  void add(Component&, TickAccount& account) override { last = &account; }
  bool remove(Component&) override { return true; }
  TickAccount* last = nullptr;
};

class ControlTest : public ::testing::Test {
 protected:
  ControlTest() { bus_.add(sut_); }
  composition_service::LoadNode::Response load(const std::string& name,
                                               const std::string& plugin = "idle") {
    Asker<composition_service::LoadNode> asker(bus_, "drive_container");
    composition_service::LoadNode::Request request;
    request.plugin_name(plugin);
    request.node_name(name);
    (void)states_.take();
    const auto response = asker.ask(request);
    EXPECT_TRUE(response);
    return response ? *response : composition_service::LoadNode::Response();
  }
  State state() {
    const auto taken = states_.take();
    return taken.empty() ? State{} : taken.back();
  }
  /// Another container of the host has an instance `name`.
  void hear_neighbour(const std::string& container, const std::string& name) {
    State state;
    state.container(container);
    state.pid(99);
    state.components().resize(1);
    state.components()[0].name(name);
    bus_.publish<topic::ContainerState>(state);
  }
  diagnostic_msgs::msg::DiagnosticArray next_report() {
    (void)reports_.take();
    bus_.run_for(seconds(1.5));
    const auto taken = reports_.take();
    return taken.empty() ? diagnostic_msgs::msg::DiagnosticArray{} : taken.back();
  }

  SimBus bus_;
  SimReader<topic::ContainerState> states_{bus_};
  SimReader<topic::Diagnostics> reports_{bus_};
  NoTicker ticker_;
  Context context_ =
      Context(bus_, "control", Role::uxv).with_node("drive_container").with_run_dir("/runs/7");
  Instances instances_{context_, ticker_, entry_of};
  std::uint64_t resident_ = 20U << 20U;
  std::optional<std::uint64_t> free_ = std::uint64_t{1} << 40U;
  std::string folder_;
  rtps_filter::DropAccount dropped_;
  RefusedNames refused_;
  ControlComponent sut_{context_,
                        {},
                        {"uxv", "drive", 1},
                        instances_,
                        {[this] { return resident_; },
                         [this](const std::string& folder) { return folder_ = folder, free_; },
                         [this] { return dropped_; },
                         {},
                         [this] { return refused_; }}};
};

TEST_F(ControlTest, LoadsAndTellsItsNewState) {
  EXPECT_TRUE(load("a").success());
  const State told = state();
  ASSERT_EQ(told.components().size(), 1U);
  EXPECT_EQ(told.components()[0].state(), "active");
  EXPECT_EQ(told.host(), "uxv");
}

TEST_F(ControlTest, TellsWhatItsRouterRefusedOnceThereIsSomething) {
  const auto findings = [this] {
    std::vector<std::string> found;
    const auto report = next_report();
    for (const auto& status : report.status()) {
      if (status.name() == "drive/link refused") found.push_back(status.message());
    }
    return found;
  };
  EXPECT_THAT(findings(), ::testing::IsEmpty());
  (void)refused_.add("topic cmd_vel", "gcs");
  EXPECT_THAT(findings(), ::testing::ElementsAre("1 refused on the link: topic cmd_vel from gcs"));
  EXPECT_THAT(findings(), ::testing::ElementsAre("past events"));
}

TEST_F(ControlTest, TellsOfDroppedPacketsOnceThereAreSome) {
  const auto statuses = [this] {
    std::vector<std::string> found;
    const auto report = next_report();
    for (const auto& status : report.status()) {
      if (status.name() == "drive/packets dropped") found.push_back(status.message());
    }
    return found;
  };
  EXPECT_TRUE(statuses().empty());
  dropped_.add(rtps_filter::DropReason::fragment, rtps_filter::ipv4(10, 0, 0, 9));
  EXPECT_THAT(statuses(), ElementsAre("1 packets dropped, from 10.0.0.9: fragment 1"));
  EXPECT_THAT(statuses(), ElementsAre("past events"));
}

TEST_F(ControlTest, AnswersWithTheReasonOfARefusal) {
  EXPECT_THAT(load("a", "idel").error_message(), HasSubstr("component 'idel': no library"));
}

TEST_F(ControlTest, AQosChangeIsTheBusesAndAnswersWithTheNumberOfEnds) {
  Asker<composition_service::SetQos> asker(bus_, "drive_container");
  composition_service::SetQos::Request request;
  request.topic("odom");
  request.writers(true);
  request.settings("{deadline_s: 0.5}");
  const auto response = asker.ask(request);
  ASSERT_TRUE(response);
  EXPECT_TRUE(response->success()) << response->message();
  EXPECT_EQ(response->ends(), 0U) << "the bus of a simulation has no ends";
}

TEST_F(ControlTest, RefusesANameThatANeighbourHas) {
  hear_neighbour("payload", "a");
  EXPECT_THAT(load("a").error_message(),
              HasSubstr("two nodes of one name; the name is taken in container payload"));
}

TEST_F(ControlTest, ANeighbourThatFellSilentHoldsNoName) {
  hear_neighbour("payload", "a");
  bus_.run_for(seconds(5));
  EXPECT_TRUE(load("a").success());
}

TEST_F(ControlTest, ReportsTwoNodesOfOneName) {
  EXPECT_TRUE(load("a").success());
  hear_neighbour("payload", "a");
  EXPECT_THAT(next_report().status()[1].message(), HasSubstr("also in container payload"));
}

TEST_F(ControlTest, ReportsTwoContainersOfOneName) {
  hear_neighbour("drive", "x");
  EXPECT_THAT(next_report().status()[0].message(), HasSubstr("two containers of one name"));
}

TEST_F(ControlTest, ReportsAComponentThatThrew) {
  EXPECT_TRUE(load("a").success());
  ticker_.last->fail("broken");
  const auto report = next_report();
  EXPECT_EQ(report.status()[1].message(), "threw: broken");
  EXPECT_EQ(state().components()[0].error(), "broken");
}

TEST_F(ControlTest, ReportsEachInstanceAndTheProcessOnceAPeriod) {
  EXPECT_TRUE(load("a").success());
  (void)reports_.take();
  bus_.run_for(seconds(3.5));  // the first comes at its phase
  const auto reports = reports_.take();
  EXPECT_EQ(reports.size(), 3U);
  ASSERT_EQ(reports[0].status().size(), 2U);
  EXPECT_EQ(reports[0].status()[0].name(), "drive");
  EXPECT_EQ(reports[0].status()[1].name(), "drive/a");
  EXPECT_EQ(reports[0].status()[1].hardware_id(), "uxv");
}

TEST_F(ControlTest, AContainerThatLeaksIsSeen) {
  bus_.run_for(seconds(20));
  resident_ += 65U << 20U;
  EXPECT_THAT(next_report().status()[0].message(), HasSubstr("leaks: resident memory grew by 65"));
}

TEST_F(ControlTest, AsksForTheRoomOfItsRunFolder) {
  EXPECT_EQ(next_report().status()[0].level(), 0);
  free_ = 0;
  EXPECT_THAT(next_report().status()[0].message(), HasSubstr("disk of /runs/7 is full"));
  EXPECT_EQ(folder_, "/runs/7");
}

TEST_F(ControlTest, TheMemoryOfTheStartIsNoLeak) {
  resident_ += 65U << 20U;
  EXPECT_EQ(next_report().status()[0].message(), "running");
}

}  // namespace
}  // namespace tocsin
