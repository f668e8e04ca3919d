// SPDX-License-Identifier: Apache-2.0
#include "operator_console/operator_console_component.hpp"

#include <gtest/gtest.h>

#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

class OperatorConsoleComponentTest : public ::testing::Test {
 protected:
  void order(const char* what) {
    OperatorConsoleComponent::Params params;
    params.order = what;
    sut_ = std::make_unique<OperatorConsoleComponent>(
        context_, params, [this](const std::string& line) { lines_.push_back(line); });
    bus_.add(*sut_);
  }
  template <class Topic>
  void hear(bool pressed) {
    typename Topic::Message message;
    if constexpr (std::is_same_v<Topic, topic::SafetyStatus>) {
      message.emergency_stop(pressed);
    } else {
      message.data(pressed);
    }
    bus_.publish<Topic>(message);
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
  Context context_{bus_, "operator_console", "gcs", "", [this](int code) { code_ = code; }};
  SimReader<topic::EmergencyStopRequest> requests_{bus_};
  SimReader<topic::DockingCommand> commands_{bus_};
  std::vector<std::string> lines_;
  std::unique_ptr<OperatorConsoleComponent> sut_;
};

TEST_F(OperatorConsoleComponentTest, RepeatsTheEmergencyStopUntilTheVehicleStands) {
  order("estop_on");
  bus_.run_for(seconds(1.2));
  EXPECT_EQ(requests_.take().size(), 3U);
  hear<topic::EmergencyStop>(true);
  EXPECT_FALSE(code_);
  hear<topic::SafetyStatus>(true);
  EXPECT_EQ(code_, 0);
  EXPECT_EQ(lines_, (std::vector<std::string>{"emergency stop ON: the vehicle stands"}));
}

TEST_F(OperatorConsoleComponentTest, GivesUpAfterItsWait) {
  order("estop_off");
  bus_.run_for(seconds(4.9));
  EXPECT_FALSE(code_);
  bus_.run_for(seconds(0.2));
  EXPECT_EQ(code_, 1);
  requests_.take();
  bus_.run_for(seconds(5));
  EXPECT_TRUE(requests_.take().empty());
}

TEST_F(OperatorConsoleComponentTest, StatusOrdersNothing) {
  order("estop_status");
  hear<topic::EmergencyStop>(false);
  hear<topic::SafetyStatus>(false);
  EXPECT_EQ(code_, 0);
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

TEST_F(OperatorConsoleComponentTest, ADockThatWasNotFoundIsAFailure) {
  order("dock_start");
  hear_docking(1, "scan", "none");
  hear_docking(1, "done", "no_dock_found");
  EXPECT_EQ(code_, 1);
}

TEST_F(OperatorConsoleComponentTest, CancelsDocking) {
  order("dock_cancel");
  bus_.run_for(seconds(0.1));
  EXPECT_EQ(commands_.take().back().data(), "cancel");
  hear_docking(1, "done", "cancelled");
  EXPECT_EQ(code_, 0);
}

}  // namespace
}  // namespace tocsin
