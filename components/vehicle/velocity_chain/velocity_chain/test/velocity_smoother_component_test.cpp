// SPDX-License-Identifier: Apache-2.0
#include "velocity_smoother/velocity_smoother_component.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>

#include "runtime/component_entry.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

class VelocitySmootherComponentTest : public ::testing::Test {
 protected:
  VelocitySmootherComponentTest() { bus_.add(sut_); }
  /// Sends the command every 50 ms; the speeds that came out meanwhile.
  std::vector<double> drive(double linear_mps, double s) {
    for (int i = 0; i < std::lround(s * 20); ++i) {
      topic::CmdVelSelected::Message message;
      message.linear().x(linear_mps);
      bus_.publish<topic::CmdVelSelected>(message);
      bus_.run_for(seconds(0.05));
    }
    return speeds();
  }
  std::vector<double> coast(double s) {
    bus_.run_for(seconds(s));
    return speeds();
  }
  std::vector<double> speeds() {
    std::vector<double> all;
    for (const auto& command : commands_.take()) all.push_back(command.linear().x());
    return all;
  }

  SimBus bus_;
  Context context_{bus_, "velocity_smoother", Role::uxv};
  SimReader<topic::CmdVelSmoothed> commands_{bus_};
  VelocitySmootherComponent sut_{context_, {}};
};

TEST_F(VelocitySmootherComponentTest, RepeatsASteadyVelocityOftenEnoughForTheDriver) {
  drive(0.3, 2);
  const auto all = drive(0.3, 10);
  EXPECT_NEAR(static_cast<double>(all.size()), 40, 2);  // the driver's limit is 0.6 s
  for (const double speed : all) EXPECT_EQ(speed, 0.3);
}

TEST_F(VelocitySmootherComponentTest, BrakesToZeroAndSleepsWhenTheMuxDies) {
  drive(0.3, 2);
  const auto all = coast(2);
  EXPECT_EQ(all.back(), 0);
  EXPECT_EQ(sut_.schedule().due(), never);
  EXPECT_TRUE(coast(10).empty());
}

TEST(CheckedVelocitySmoother, ListensToTheBrakeOnly) {
  SimBus bus;
  Context context{bus, "velocity_smoother", Role::uxv};
  VelocitySmootherComponent::Params params;
  params.checked = true;
  VelocitySmootherComponent sut{context, params};
  bus.add(sut);
  SimReader<topic::CmdVelSmoothed> commands{bus};
  geometry_msgs::msg::Twist message;
  message.linear().x(0.3);
  bus.publish<topic::CmdVelSelected>(message);
  bus.run_for(seconds(0.2));
  EXPECT_TRUE(commands.take().empty());
  bus.publish<topic::CmdVelChecked>(message);
  bus.run_for(seconds(0.2));
  EXPECT_FALSE(commands.take().empty());
}

TEST_F(VelocitySmootherComponentTest, StandsAndSleepsBeforeTheFirstCommand) {
  EXPECT_TRUE(coast(10).empty());
  EXPECT_EQ(sut_.schedule().due(), never);
}

TEST_F(VelocitySmootherComponentTest, BrakesOnNumbersThatAreNone) {
  drive(0.3, 2);
  EXPECT_EQ(drive(std::nan(""), 2).back(), 0);
}

TEST_F(VelocitySmootherComponentTest, TakesOtherLimitsWhileItRunsAndKeepsItsOwnOnARefusal) {
  const ComponentEntry entry = make_component_entry<VelocitySmootherComponent>();
  entry.change(sut_, YAML::Load("{speed_lim_v_mps: 0.2}"), {});
  EXPECT_NEAR(drive(0.3, 3).back(), 0.2, 1e-9);
  EXPECT_THROW(entry.change(sut_, YAML::Load("{speed_lim_v_mps: 2.5}"), {}), ConfigError);
  EXPECT_NEAR(drive(0.3, 1).back(), 0.2, 1e-9);
}

}  // namespace
}  // namespace tocsin
