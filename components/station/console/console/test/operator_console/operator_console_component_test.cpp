// SPDX-License-Identifier: Apache-2.0
#include "operator_console/operator_console_component.hpp"

#include <gtest/gtest.h>

#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

class OperatorConsoleComponentTest : public ::testing::Test {
 protected:
  void order(const char* what) {
    params_.order = value_of<ConsoleOrder>(what).value();
    sut_ = std::make_unique<OperatorConsoleComponent>(
        context_, params_, [this](const std::string& line) { lines_.push_back(line); });
    bus_.add(*sut_);
  }
  void hear_vehicle(bool stands) {
    topic::SafetyStatus::Message message;
    message.emergency_stop(stands);
    bus_.publish<topic::SafetyStatus>(message);
    bus_.run_for(seconds(0.01));
  }
  void hear_station(const char* asked, const char* vehicle) {
    topic::EmergencyStopState::Message message;
    message.asked(asked);
    message.vehicle(vehicle);
    bus_.publish<topic::EmergencyStopState>(message);
    bus_.run_for(seconds(0.01));
  }
  void hear_link(bool stands, double silence_s = 0.05) {
    topic::LinkStop::Message message;
    message.stands(stands);
    if (stands) message.stopped_by({"station"});
    message.silence_s(silence_s);
    bus_.publish<topic::LinkStop>(message);
    bus_.run_for(seconds(0.01));
  }
  void hear_docking(std::uint32_t run, const char* state, const char* result) {
    topic::DockingStatus::Message message;
    message.run(run);
    message.state(state);
    message.result(result);
    bus_.publish<topic::DockingStatus>(message);
    bus_.run_for(seconds(0.01));
  }

  SimBus bus_;
  std::optional<int> code_;
  Context context_ =
      Context(bus_, "operator_console", Role::gcs).with_request_exit([this](int code) {
        code_ = code;
      });
  SimReader<topic::EmergencyStopRequest> requests_{bus_};
  SimReader<topic::DockingCommand> commands_{bus_};
  SimReader<topic::EmergencyStop> stops_{bus_};
  OperatorConsoleComponent::Params params_;
  std::vector<std::string> lines_;
  std::unique_ptr<OperatorConsoleComponent> sut_;
};

TEST_F(OperatorConsoleComponentTest, RepeatsTheEmergencyStopUntilTheVehicleStands) {
  order("estop_on");
  bus_.run_for(seconds(1.2));
  EXPECT_EQ(requests_.take().size(), 3U);
  hear_station("on", "may_drive");
  EXPECT_FALSE(code_);
  hear_vehicle(true);
  EXPECT_EQ(code_, 0);
  EXPECT_EQ(lines_, (std::vector<std::string>{"emergency stop ON: the vehicle stands"}));
}

TEST_F(OperatorConsoleComponentTest, BelievesTheStationWhatTheVehicleSaid) {
  order("estop_on");
  hear_station("on", "stands");
  EXPECT_EQ(code_, 0);
}

TEST_F(OperatorConsoleComponentTest, TheLinkConfirmsThatTheVehicleStands) {
  order("estop_on");
  hear_station("on", "may_drive");
  hear_link(true, 7);
  EXPECT_FALSE(code_) << "the value is not fresh";
  hear_link(true);
  EXPECT_EQ(code_, 0);
  EXPECT_EQ(lines_, (std::vector<std::string>{"emergency stop ON: the vehicle stands"}));
}

TEST_F(OperatorConsoleComponentTest, AStatusThatIsOldDoesNotDenyWhatTheLinkReports) {
  order("estop_off");
  hear_vehicle(true);
  hear_station("off", "stands");
  bus_.run_for(seconds(1));
  EXPECT_FALSE(code_);
  hear_link(false);
  EXPECT_EQ(code_, 0);
}

TEST_F(OperatorConsoleComponentTest, AtTheVehicleAReleaseIsSaidToItselfAndToItsRouter) {
  context_.role = Role::uxv;
  params_.direct = true;
  order("estop_off");
  hear_vehicle(true);
  bus_.run_for(seconds(0.6));
  const auto said = stops_.take();
  ASSERT_FALSE(said.empty());
  EXPECT_FALSE(said.back().data());
  const auto asked = requests_.take();
  ASSERT_EQ(asked.size(), 2U);
  EXPECT_FALSE(asked.back().data());
  hear_vehicle(false);
  EXPECT_EQ(code_, 0);
}

TEST_F(OperatorConsoleComponentTest, AtTheVehicleTheLinkIsNotTheAnswer) {
  context_.role = Role::uxv;
  params_.direct = true;
  order("estop_on");
  hear_link(true);
  EXPECT_FALSE(code_);
  EXPECT_TRUE(stops_.take().back().data());
  EXPECT_TRUE(requests_.take().empty());
}

TEST_F(OperatorConsoleComponentTest, StartsDockingAndTellsItsSteps) {
  order("dock_start");
  bus_.run_for(seconds(0.1));
  EXPECT_EQ(commands_.take().back().data(), "start");
  hear_docking(1, "scan", "none");
  hear_docking(1, "aligned_far", "none");
  hear_docking(1, "done", "docked");
  EXPECT_EQ(code_, 0);
  EXPECT_EQ(lines_, (std::vector<std::string>{"0 s: scan", "0 s: aligned_far", "docking docked"}));
}

}  // namespace
}  // namespace tocsin
