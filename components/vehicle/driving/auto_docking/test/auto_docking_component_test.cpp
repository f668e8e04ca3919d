// SPDX-License-Identifier: Apache-2.0
#include "auto_docking/auto_docking_component.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

class AutoDockingComponentTest : public ::testing::Test {
 protected:
  AutoDockingComponentTest() {
    bus_.add(sut_);
    bus_.run_for(seconds(0.1));
  }
  void command(const char* text) {
    topic::DockingCommand::Message message;
    message.data(text);
    bus_.publish<topic::DockingCommand>(message);
    bus_.run_for(seconds(0.001));
  }
  /// Frames of the base at 50 Hz, with what the centre receiver sees.
  void frames(double s, std::uint8_t centre = 0, std::uint8_t charger = 0) {
    for (int i = 0; i < std::lround(s * 50); ++i) {
      topic::Odom::Message odom;
      odom.pose().pose().orientation().w(std::cos(heading_rad_ / 2));
      odom.pose().pose().orientation().z(std::sin(heading_rad_ / 2));
      bus_.publish<topic::Odom>(odom);
      topic::DockInfrared::Message infrared;
      infrared.data({0, centre, 0});
      topic::SensorsCore::Message core;
      core.charger(charger);
      bus_.publish<topic::SensorsCore>(core);
      bus_.publish<topic::DockInfrared>(infrared);
      bus_.run_for(seconds(0.02));
    }
  }
  /// The light passes while the base turns, which then faces it.
  void drive_in(std::uint8_t centre) {
    heading_rad_ = -1;
    frames(0.5);
    heading_rad_ = 0;
    frames(0.1, centre);
    heading_rad_ = 1;
    frames(0.5);
    frames(0.1, centre);
    heading_rad_ = 0;
    frames(0.1, centre);
  }
  topic::DockingStatus::Message status() {
    for (const auto& one : statuses_.take()) status_ = one;
    return status_;
  }

  SimBus bus_;
  Context context_{bus_, "auto_docking", Role::uxv};
  SimReader<topic::CmdVelDocking> commands_{bus_};
  SimReader<topic::DockingStatus> statuses_{bus_};
  AutoDockingComponent sut_{context_, {}};
  topic::DockingStatus::Message status_;
  double heading_rad_ = 0;
};

TEST_F(AutoDockingComponentTest, IsIdleAndAsleepUntilItIsTold) {
  frames(1);
  EXPECT_TRUE(commands_.take().empty());
  EXPECT_EQ(status().state(), "idle");
  EXPECT_EQ(sut_.schedule().due(), never);
  bus_.publish<topic::SensorsCore>({});
  EXPECT_FALSE(sut_.schedule().input_pending);
}

TEST_F(AutoDockingComponentTest, ScansDrivesInAndReportsThatItIsDocked) {
  command("start");
  frames(0.1);
  EXPECT_EQ(status().state(), "scan");
  EXPECT_NEAR(commands_.take().back().angular().z(), 0.66, 1e-9);
  drive_in(8);
  EXPECT_EQ(status().state(), "aligned_far");
  frames(1, 2, 6);
  EXPECT_EQ(status().state(), "done");
  EXPECT_EQ(status().result(), "docked");
  EXPECT_EQ(commands_.take().back().linear().x(), 0);
  EXPECT_EQ(sut_.schedule().due(), never);
}

TEST_F(AutoDockingComponentTest, StopsWithAZeroWhenItIsCancelled) {
  command("start");
  drive_in(8);
  EXPECT_GT(commands_.take().back().linear().x(), 0);
  command("cancel");
  EXPECT_EQ(status().result(), "cancelled");
  EXPECT_EQ(commands_.take().back().linear().x(), 0);
  frames(1, 8);
  EXPECT_TRUE(commands_.take().empty());
}

TEST_F(AutoDockingComponentTest, StopsWhenTheSensorsFallSilent) {
  command("start");
  frames(0.5, 8);
  bus_.run_for(seconds(0.47));
  EXPECT_EQ(status().result(), "none");
  bus_.run_for(seconds(0.05));
  EXPECT_EQ(status().result(), "sensors_lost");
  EXPECT_EQ(commands_.take().back().linear().x(), 0);
}

TEST_F(AutoDockingComponentTest, WaitsFiveSecondsForTheFirstSensors) {
  command("start");
  bus_.run_for(seconds(4.9));
  EXPECT_EQ(status().result(), "none");
  bus_.run_for(seconds(0.2));
  EXPECT_EQ(status().result(), "sensors_lost");
  command("start");
  bus_.publish<topic::DockInfrared>({});  // too short
  frames(0.1);
  EXPECT_EQ(status().state(), "scan");
  EXPECT_EQ(status().run(), 2U);
  statuses_.take();
  frames(3);
  EXPECT_NEAR(static_cast<double>(statuses_.take().size()), 3, 1);
}

TEST_F(AutoDockingComponentTest, AStartWhileItRunsChangesNothing) {
  command("start");
  drive_in(8);
  command("start");
  EXPECT_EQ(status().run(), 1U);
  EXPECT_EQ(status().state(), "aligned_far");
}

TEST_F(AutoDockingComponentTest, IgnoresOtherWords) {
  command("go");
  EXPECT_EQ(status().run(), 0U);
}

/// A client of the action.
class Docker : public Component {
 public:
  using Client = ActionClient<action::AutoDocking>;
  explicit Docker(Context& context) : Component(context) {}
  void tick(Time now) override {
    while (auto one = client.take(now)) {
      if (one->what == Client::What::feedback) states.push_back(one->feedback->state());
      last = *one;
    }
  }
  GoalId send() { return client.send({}, bus().now() + seconds(1), bus().now() + seconds(300)); }
  void cancel(const GoalId& id) { client.cancel(id, bus().now() + seconds(1)); }
  Client client{*this};
  Client::News last{};
  std::vector<std::string> states;
};

class AutoDockingActionTest : public AutoDockingComponentTest {
 protected:
  AutoDockingActionTest() { bus_.add(docker_); }
  Context docker_context_{bus_, "docker", Role::uxv};
  Docker docker_{docker_context_};
  using What = Docker::Client::What;
};

TEST_F(AutoDockingActionTest, DocksTellsItsStatesAndSucceeds) {
  docker_.send();
  frames(0.1);
  EXPECT_EQ(status().state(), "scan");
  drive_in(8);
  frames(1, 2, 6);
  EXPECT_EQ(docker_.last.what, What::result);
  EXPECT_EQ(docker_.last.state, GoalState::succeeded);
  EXPECT_EQ(docker_.last.result->text(), "docked");
  ASSERT_GE(docker_.states.size(), 3U);
  EXPECT_EQ(docker_.states.front(), "scan");
}

TEST_F(AutoDockingActionTest, StopsWithAZeroWhenItsGoalIsCanceled) {
  const GoalId id = docker_.send();
  drive_in(8);
  EXPECT_GT(commands_.take().back().linear().x(), 0);
  docker_.cancel(id);
  bus_.run_for(seconds(0.001));
  EXPECT_EQ(commands_.take().back().linear().x(), 0);
  EXPECT_EQ(docker_.last.what, What::result);
  EXPECT_EQ(docker_.last.state, GoalState::canceled);
  EXPECT_EQ(docker_.last.result->text(), "cancelled");
}

TEST_F(AutoDockingActionTest, AnEndThatNobodyAskedForIsAnAbort) {
  docker_.send();
  frames(0.5, 8);
  bus_.run_for(seconds(0.6));
  EXPECT_EQ(docker_.last.state, GoalState::aborted);
  EXPECT_EQ(docker_.last.result->text(), "sensors_lost");
  docker_.send();
  frames(0.1);
  command("cancel");
  EXPECT_EQ(docker_.last.state, GoalState::aborted);
  EXPECT_EQ(docker_.last.result->text(), "cancelled");
}

TEST_F(AutoDockingActionTest, AGoalWhileItDocksIsRejected) {
  command("start");
  docker_.send();
  frames(0.1);
  EXPECT_EQ(docker_.last.what, What::rejected);
  ASSERT_TRUE(docker_.last.result);
  EXPECT_EQ(docker_.last.result->text(), "docking runs already");
  EXPECT_EQ(status().run(), 1U);
}

}  // namespace
}  // namespace tocsin
