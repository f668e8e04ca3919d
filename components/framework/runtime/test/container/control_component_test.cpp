// SPDX-License-Identifier: Apache-2.0
#include "container/control_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Command = tocsin_msgs::msg::ContainerCommand;
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
  Command command(const std::string& verb, const std::string& name) {
    Command message;
    message.id(next_id_++);
    message.container("drive");
    message.verb(verb);
    message.library("idle");
    message.name(name);
    return message;
  }
  State ask(const Command& message) {
    (void)states_.take();
    bus_.publish<topic::ContainerCommand>(message);
    bus_.run_for(Duration::zero());
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

  std::uint64_t next_id_ = 7;
  SimBus bus_;
  SimReader<topic::ContainerState> states_{bus_};
  SimReader<topic::Diagnostics> reports_{bus_};
  NoTicker ticker_;
  Context context_ = Context(bus_, "control", Role::uxv).with_run_dir("/runs/7");
  Instances instances_{context_, ticker_, entry_of};
  std::uint64_t resident_ = 20U << 20U;
  std::optional<std::uint64_t> free_ = std::uint64_t{1} << 40U;
  std::string folder_;
  rtps_filter::DropAccount dropped_;
  ControlComponent sut_{context_,
                        {},
                        {"uxv", "drive", 1},
                        instances_,
                        {[this] { return resident_; },
                         [this](const std::string& folder) { return folder_ = folder, free_; },
                         [this] { return dropped_; }}};
};

TEST_F(ControlTest, LoadsAndAnswersWithTheNewState) {
  const State state = ask(command("load", "a"));
  ASSERT_EQ(state.answers().size(), 1U);
  EXPECT_EQ(state.answers()[0].id(), 7U);
  EXPECT_TRUE(state.answers()[0].done());
  ASSERT_EQ(state.components().size(), 1U);
  EXPECT_EQ(state.components()[0].state(), "active");
  EXPECT_EQ(state.host(), "uxv");
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
  Command unknown = command("load", "a");
  unknown.library("idel");
  EXPECT_THAT(ask(unknown).answers()[0].text(), HasSubstr("component 'idel': no library"));
  EXPECT_FALSE(ask(command("dance", "a")).answers()[1].done());
}

TEST_F(ControlTest, ObeysARepeatedCommandOnce) {
  const Command load = command("load", "a");
  (void)ask(load);
  const State state = ask(load);
  EXPECT_EQ(state.answers().size(), 1U);
  EXPECT_EQ(state.components().size(), 1U);
}

TEST_F(ControlTest, AQosChangeIsTheBusesAndAnswersWithTheNumberOfEnds) {
  Command change = command("set_qos", "odom");
  change.library("");
  change.parameters("{deadline_s: 0.5}");
  const State state = ask(change);
  ASSERT_EQ(state.answers().size(), 1U);
  EXPECT_TRUE(state.answers()[0].done());
  EXPECT_EQ(state.answers()[0].text(), "0") << "the bus of a simulation has no ends";
}

TEST_F(ControlTest, LeavesTheCommandsOfOthersAlone) {
  Command other = command("load", "a");
  other.container("payload");
  EXPECT_TRUE(ask(other).answers().empty());
}

TEST_F(ControlTest, WalksThroughTheLifecycle) {
  (void)ask(command("load", "a"));
  EXPECT_EQ(ask(command("deactivate", "a")).components()[0].state(), "inactive");
  EXPECT_EQ(ask(command("cleanup", "a")).components()[0].state(), "unconfigured");
  EXPECT_EQ(ask(command("configure", "a")).components()[0].state(), "inactive");
  EXPECT_EQ(ask(command("activate", "a")).components()[0].state(), "active");
  EXPECT_EQ(ask(command("shutdown", "a")).components()[0].state(), "finalized");
}

TEST_F(ControlTest, RefusesANameThatANeighbourHas) {
  hear_neighbour("payload", "a");
  EXPECT_THAT(ask(command("load", "a")).answers()[0].text(),
              HasSubstr("two nodes of one name; the name is taken in container payload"));
}

TEST_F(ControlTest, ANeighbourThatFellSilentHoldsNoName) {
  hear_neighbour("payload", "a");
  bus_.run_for(seconds(5));
  EXPECT_TRUE(ask(command("load", "a")).answers()[0].done());
}

TEST_F(ControlTest, ReportsTwoNodesOfOneName) {
  (void)ask(command("load", "a"));
  hear_neighbour("payload", "a");
  EXPECT_THAT(next_report().status()[1].message(), HasSubstr("also in container payload"));
}

TEST_F(ControlTest, ReportsTwoContainersOfOneName) {
  hear_neighbour("drive", "x");
  EXPECT_THAT(next_report().status()[0].message(), HasSubstr("two containers of one name"));
}

TEST_F(ControlTest, ReportsAComponentThatThrew) {
  (void)ask(command("load", "a"));
  ticker_.last->fail("broken");
  const auto report = next_report();
  EXPECT_EQ(report.status()[1].message(), "threw: broken");
  EXPECT_EQ(ask(command("report", "")).components()[0].error(), "broken");
}

TEST_F(ControlTest, ReportsEachInstanceAndTheProcessOnceAPeriod) {
  (void)ask(command("load", "a"));
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
