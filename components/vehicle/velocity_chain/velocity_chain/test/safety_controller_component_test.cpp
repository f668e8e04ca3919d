// SPDX-License-Identifier: Apache-2.0
#include "safety_controller/safety_controller_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "foundation/temporary_folder.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class SafetyControllerComponentTest : public ::testing::Test {
 protected:
  SafetyControllerComponentTest() { start(); }
  void start() {
    sut_ = std::make_unique<SafetyControllerComponent>(context_, params_);
    sut_->tick(bus_.now());
    commands_.take();
  }
  /// One tick after `s`; the last command that came out, if any.
  std::optional<double> speed_after(double s = 0.01) {
    bus_.run_for(seconds(s));
    sut_->tick(bus_.now());
    const auto all = commands_.take();
    return all.empty() ? std::nullopt : std::optional<double>(all.back().linear().x());
  }
  std::optional<double> drive(double linear_mps) {
    topic::CmdVelSmoothed::Message message;
    message.linear().x(linear_mps);
    bus_.publish<topic::CmdVelSmoothed>(message);
    return speed_after();
  }
  void bump(int index, bool pressed) {
    topic::BumperEvents::Message message;
    message.bumper(static_cast<std::uint8_t>(index));
    message.state(pressed ? 1 : 0);
    bus_.publish<topic::BumperEvents>(message);
  }
  template <class Topic>
  void set(bool value) {
    typename Topic::Message message;
    message.data(value);
    bus_.publish<Topic>(message);
  }

  void hear_link(bool stands) {
    topic::LinkStop::Message message;
    message.stands(stands);
    if (stands) message.stopped_by({"station"});
    bus_.publish<topic::LinkStop>(message);
  }
  using Station = SimWriter<topic::EmergencyStop>;
  static void say(Station& station, bool pressed) {
    topic::EmergencyStop::Message word;
    word.data(pressed);
    EXPECT_EQ(station.write(word), Status::ok);
  }
  std::unique_ptr<Station> press_as_station() {
    auto station = std::make_unique<Station>(bus_, topic::EmergencyStop::station);
    say(*station, true);
    return station;
  }

  SimBus bus_;
  Context context_{bus_, "safety_controller", Role::uxv};
  SafetyControllerComponent::Params params_;
  SimReader<topic::CmdVel> commands_{bus_};
  SimReader<topic::SafetyStatus> statuses_{bus_};
  std::unique_ptr<SafetyControllerComponent> sut_;
};

TEST_F(SafetyControllerComponentTest, AnEventOfASensorThatIsNotThereIsNoHazard) {
  topic::WheelDropEvents::Message drop;
  drop.wheel(2);
  drop.state(1);
  bus_.publish<topic::WheelDropEvents>(drop);
  bump(3, true);
  EXPECT_EQ(drive(0.3), 0.3);
  const auto status = statuses_.take().back();
  EXPECT_EQ(status.bumper(), 0);
  EXPECT_EQ(status.wheel_drop(), 0);
}

TEST_F(SafetyControllerComponentTest, SaysNothingOfItsOwn) {
  EXPECT_FALSE(speed_after(10));
  EXPECT_EQ(sut_->schedule().due(), never);
}

TEST_F(SafetyControllerComponentTest, BacksOffAtABump) {
  drive(0.3);
  bump(0, true);
  EXPECT_EQ(speed_after(), -0.1);
  EXPECT_EQ(drive(0.3), -0.1);
  bump(0, false);
  EXPECT_EQ(speed_after(), 0);
  EXPECT_EQ(drive(0.3), 0.3);
}

TEST_F(SafetyControllerComponentTest, OnlyStopsWhenAskedTo) {
  params_.stop_only = true;
  start();
  drive(0.3);
  bump(2, true);
  EXPECT_EQ(speed_after(), 0);
  EXPECT_EQ(drive(-0.2), -0.2);
}

TEST_F(SafetyControllerComponentTest, ReactsToACliffOfEachSideOnce) {
  topic::CliffEvents::Message cliff;
  cliff.sensor(2);
  cliff.state(1);
  bus_.publish<topic::CliffEvents>(cliff);
  bus_.publish<topic::CliffEvents>(cliff);
  EXPECT_EQ(speed_after(), -0.1);
  EXPECT_EQ(statuses_.take().back().cliff(), kobuki::right_bit);
}

TEST_F(SafetyControllerComponentTest, IgnoresAnEventOfASideThatDoesNotExist) {
  bump(3, true);
  EXPECT_EQ(drive(0.3), 0.3);
}

TEST_F(SafetyControllerComponentTest, StandsWithADroppedWheel) {
  topic::WheelDropEvents::Message drop;
  drop.wheel(0);
  drop.state(1);
  bus_.publish<topic::WheelDropEvents>(drop);
  EXPECT_EQ(drive(0.3), 0);
  EXPECT_EQ(drive(-0.3), 0);
  EXPECT_EQ(statuses_.take().back().wheel_drop(), 2);
}

TEST_F(SafetyControllerComponentTest, KnowsWhatWasPressedBeforeItStarted) {
  topic::SensorsCore::Message sensors;
  sensors.bumper(kobuki::centre_bit);
  bus_.publish<topic::SensorsCore>(sensors);
  EXPECT_EQ(drive(0.3), -0.1);
  bump(1, false);
  EXPECT_EQ(speed_after(), 0);
}

TEST_F(SafetyControllerComponentTest, IsNotWokenByEverySample) {
  bus_.publish<topic::SensorsCore>({});
  speed_after();
  sut_->schedule().begin_tick(bus_.now());
  bus_.publish<topic::SensorsCore>({});
  EXPECT_FALSE(sut_->schedule().input_pending);
}

TEST_F(SafetyControllerComponentTest, StandsAtOnceOnEmergencyStopUntilItIsReleased) {
  drive(0.5);
  set<topic::EmergencyStop>(true);
  EXPECT_EQ(speed_after(), 0);
  EXPECT_EQ(drive(0.5), 0);
  EXPECT_TRUE(statuses_.take().back().emergency_stop());
  set<topic::EmergencyStop>(false);
  EXPECT_FALSE(speed_after());
  EXPECT_EQ(drive(0.5), 0.5);
}

TEST_F(SafetyControllerComponentTest, TheFalseOfAnotherDoesNotReleaseTheEmergencyStop) {
  const auto station = press_as_station();
  set<topic::EmergencyStop>(false);
  EXPECT_EQ(drive(0.5), 0);
  EXPECT_THAT(statuses_.take().back().stopped_by(), ElementsAre("station"));
  set<topic::EmergencyStop>(true);
  (void)speed_after();
  EXPECT_THAT(statuses_.take().back().stopped_by(), ElementsAre("station", HasSubstr("anybody")));
  set<topic::EmergencyStop>(false);
  say(*station, false);
  EXPECT_EQ(drive(0.5), 0.5);
  EXPECT_THAT(statuses_.take().back().stopped_by(), IsEmpty());
}

TEST_F(SafetyControllerComponentTest, StandsStillAfterARestartThoughItHearsNobody) {
  const TemporaryFolder folder;
  context_.run_dir = folder.path();
  start();
  EXPECT_EQ(drive(0.5), 0.5);
  auto station = press_as_station();
  (void)speed_after();
  station.reset();
  sut_.reset();
  start();
  EXPECT_EQ(drive(0.5), 0);
  EXPECT_THAT(statuses_.take().back().stopped_by(), ElementsAre("station"));
  station = press_as_station();
  say(*station, false);
  EXPECT_EQ(drive(0.5), 0.5);
  sut_.reset();
  start();
  EXPECT_EQ(drive(0.5), 0.5);
}

TEST_F(SafetyControllerComponentTest, AStopOfAnotherLaunchIsNotKept) {
  const TemporaryFolder folder;
  context_.run_dir = folder.path();
  StateFile other(folder.path("safety_controller.stop"));
  ASSERT_TRUE(other.save("1 1 1 1 1"));
  start();
  EXPECT_EQ(drive(0.5), 0.5);
}

TEST_F(SafetyControllerComponentTest, StandsWhileTheLinkSaysSo) {
  drive(0.5);
  hear_link(true);
  EXPECT_EQ(speed_after(), 0);
  EXPECT_EQ(drive(0.5), 0);
  EXPECT_THAT(statuses_.take().back().stopped_by(), ElementsAre("station"));
  hear_link(false);
  EXPECT_EQ(drive(0.5), 0.5);
  EXPECT_FALSE(statuses_.take().back().emergency_stop());
}

TEST_F(SafetyControllerComponentTest, StandsWhenTheRouterFallsSilent) {
  hear_link(false);
  EXPECT_EQ(drive(0.5), 0.5);
  const Time silent = sut_->schedule().due();
  EXPECT_LE(silent, bus_.now() + seconds(1));
  EXPECT_EQ(speed_after(1), 0);
  EXPECT_THAT(statuses_.take().back().stopped_by(), ElementsAre("link_router is silent"));
}

TEST_F(SafetyControllerComponentTest, AStopOfTheLinkStandsOverARestart) {
  const TemporaryFolder folder;
  context_.run_dir = folder.path();
  start();
  hear_link(true);
  EXPECT_EQ(drive(0.5), 0);
  sut_.reset();
  start();
  EXPECT_EQ(drive(0.5), 0);
  hear_link(false);
  EXPECT_EQ(drive(0.5), 0.5);
}

TEST_F(SafetyControllerComponentTest, CanBeDisabledAndSaysSo) {
  set<topic::SafetyEnable>(false);
  bump(1, true);
  EXPECT_EQ(drive(0.3), 0.3);
  EXPECT_FALSE(statuses_.take().back().enabled());
}

TEST_F(SafetyControllerComponentTest, ReportsChangesOnly) {
  statuses_.take();
  drive(0.3);
  drive(0.2);
  EXPECT_TRUE(statuses_.take().empty());
}

}  // namespace
}  // namespace tocsin
