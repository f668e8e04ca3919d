// SPDX-License-Identifier: Apache-2.0
#include "velocity_mux/velocity_mux_component.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "foundation/error.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

class VelocityMuxComponentTest : public ::testing::Test {
 protected:
  VelocityMuxComponentTest() {
    bus_.add(sut_);
    bus_.run_for(seconds(0.1));
    commands_.take();
  }
  template <class Topic>
  void drive(double linear_mps) {
    typename Topic::Message message;
    message.linear().x(linear_mps);
    message.angular().z(0.25);
    bus_.publish<Topic>(message);
  }
  /// The speeds that came out within `s` from now on.
  std::vector<double> speeds(double s) {
    bus_.run_for(seconds(s));
    std::vector<double> all;
    for (const auto& command : commands_.take()) all.push_back(command.linear().x());
    return all;
  }
  void stop(bool pressed) {
    topic::EmergencyStop::Message message;
    message.data(pressed);
    bus_.publish<topic::EmergencyStop>(message);
  }
  void hear_link(bool stands) {
    topic::LinkStop::Message message;
    message.stands(stands);
    bus_.publish<topic::LinkStop>(message);
  }
  void set_inputs(const std::string& text) {
    topic::MuxSetInputs::Message message;
    message.data(text);
    bus_.publish<topic::MuxSetInputs>(message);
    bus_.run_for(seconds(0.001));
  }
  std::string last_inputs() {
    const auto all = inputs_.take();
    return all.empty() ? "" : all.back().data();
  }

  SimBus bus_;
  Context context_{bus_, "velocity_mux", Role::uxv};
  SimReader<topic::CmdVelSelected> commands_{bus_};
  SimReader<topic::MuxActive> active_{bus_};
  SimReader<topic::MuxInputs> inputs_{bus_};
  VelocityMuxComponent sut_{context_, {}};
};

using Speeds = std::vector<double>;

TEST_F(VelocityMuxComponentTest, PassesACommandAtOnceAndStopsOnceWhenItsSourceDies) {
  drive<topic::CmdVelNavigation>(0.3);
  EXPECT_EQ(speeds(0.499), (Speeds{0.3}));
  EXPECT_EQ(speeds(0.002), (Speeds{0}));
  EXPECT_EQ(speeds(10), (Speeds{}));
}

TEST_F(VelocityMuxComponentTest, TheOperatorTakesTheWheelAndGivesItBack) {
  drive<topic::CmdVelNavigation>(0.3);
  drive<topic::CmdVelTeleop>(0.1);
  EXPECT_EQ(speeds(0.1).back(), 0.1);
  drive<topic::CmdVelNavigation>(0.3);
  EXPECT_EQ(speeds(0.3), (Speeds{}));
  EXPECT_EQ(speeds(0.2), (Speeds{0}));  // the operator has died
  drive<topic::CmdVelNavigation>(0.3);
  EXPECT_EQ(speeds(0.1), (Speeds{0.3}));
}

TEST_F(VelocityMuxComponentTest, PassesTheMessageOfTheGreatestPriorityAsItIsAndSaysWhose) {
  EXPECT_EQ(active_.take().back().data(), "idle");
  drive<topic::CmdVelNavigation>(0.3);
  topic::CmdVelDocking::Message message;
  message.linear().x(0.05);
  message.linear().y(0.01);
  message.angular().z(-0.2);
  bus_.publish<topic::CmdVelDocking>(message);
  drive<topic::CmdVelNavigation>(0.3);
  bus_.run_for(seconds(0.1));
  EXPECT_EQ(commands_.take().back(), message);
  EXPECT_EQ(active_.take().back().data(), "docking");
  bus_.run_for(seconds(1));
  EXPECT_EQ(active_.take().back().data(), "idle");
}

TEST_F(VelocityMuxComponentTest, TheFalseOfAnotherDoesNotReleaseTheEmergencyStop) {
  SimWriter<topic::EmergencyStop> station(bus_, topic::EmergencyStop::station);
  topic::EmergencyStop::Message word;
  word.data(true);
  ASSERT_EQ(station.write(word), Status::ok);
  stop(false);
  drive<topic::CmdVelTeleop>(0.3);
  EXPECT_EQ(speeds(0.1), (Speeds{}));
  word.data(false);
  ASSERT_EQ(station.write(word), Status::ok);
  drive<topic::CmdVelTeleop>(0.3);
  EXPECT_EQ(speeds(0.1), (Speeds{0.3}));
}

TEST_F(VelocityMuxComponentTest, StandsDuringAnEmergencyStop) {
  const std::function<void(bool)> of_host = [this](bool stands) { stop(stands); };
  const std::function<void(bool)> of_link = [this](bool stands) { hear_link(stands); };
  for (const auto& tell : {of_host, of_link}) {
    drive<topic::CmdVelNavigation>(0.3);
    speeds(0.1);
    tell(true);
    EXPECT_EQ(speeds(0), (Speeds{0}));
    drive<topic::CmdVelTeleop>(0.3);
    EXPECT_EQ(speeds(0.8), (Speeds{}));
    tell(false);
    drive<topic::CmdVelTeleop>(0.3);
    EXPECT_EQ(speeds(0.1), (Speeds{0.3}));
    (void)speeds(0.6);
  }
}

TEST_F(VelocityMuxComponentTest, StandsWhenTheRouterFallsSilent) {
  hear_link(false);
  bus_.run_for(seconds(0.7));
  drive<topic::CmdVelTeleop>(0.3);
  EXPECT_EQ(speeds(0.299), (Speeds{0.3}));
  EXPECT_EQ(speeds(0.001), (Speeds{0}));
  drive<topic::CmdVelTeleop>(0.3);
  EXPECT_EQ(speeds(1), (Speeds{}));
}

TEST_F(VelocityMuxComponentTest, ChangesItsListWhileRunning) {
  set_inputs("spare 5 0.2, navigation 10 1");
  EXPECT_EQ(last_inputs(), "spare 5 0.2, navigation 10 1");
  drive<topic::CmdVelTeleop>(0.1);
  EXPECT_EQ(speeds(1), (Speeds{}));
  drive<topic::CmdVelNavigation>(0.3);
  EXPECT_EQ(speeds(0.999), (Speeds{0.3}));
  EXPECT_EQ(speeds(0.002), (Speeds{0}));
}

TEST_F(VelocityMuxComponentTest, StopsASourceThatWasRemoved) {
  drive<topic::CmdVelTeleop>(0.3);
  speeds(0.1);
  set_inputs("navigation 10 1");
  EXPECT_EQ(speeds(0), (Speeds{0}));
}

TEST_F(VelocityMuxComponentTest, KeepsItsListWhenTheNewOneIsWrongAndSaysSo) {
  set_inputs("teleop 1 0");
  EXPECT_EQ(last_inputs(), VelocityMuxComponent::Params{}.inputs);
  drive<topic::CmdVelTeleop>(0.1);
  EXPECT_EQ(speeds(0.1), (Speeds{0.1}));
}

TEST_F(VelocityMuxComponentTest, RefusesToStartWithAWrongList) {
  EXPECT_THROW(VelocityMuxComponent(context_, {"teleop"}), ConfigError);
}

}  // namespace
}  // namespace tocsin
