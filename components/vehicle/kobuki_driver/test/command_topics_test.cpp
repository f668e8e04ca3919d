// SPDX-License-Identifier: Apache-2.0
/// The command topics of kobuki_node, through the component into the base's own state.
#include <array>
#include <cmath>

#include "component_rig.hpp"

namespace tocsin {
namespace {

namespace msg = kobuki_ros_interfaces::msg;

class CommandTopicsTest : public KobukiDriverComponentTest {
 protected:
  void SetUp() override {
    start();
    run(0.5);
  }
  [[nodiscard]] unsigned outputs() const { return base_.model.outputs().outputs.bits; }
  template <class Topic>
  void led(std::uint8_t colour) {
    msg::Led message;
    message.value(colour);
    bus_.publish<Topic>(message);
    run(0.1);
  }
  void sound(std::uint8_t value) {
    msg::Sound message;
    message.value(value);
    bus_.publish<topic::SoundCommand>(message);
    run(0.1);
  }
  void supply(std::uint8_t source, std::uint8_t state) {
    msg::ExternalPower message;
    message.source(source);
    message.state(state);
    bus_.publish<topic::ExternalPower>(message);
    run(0.1);
  }
  void digital(std::array<bool, 4> values, std::array<bool, 4> mask) {
    msg::DigitalOutput message;
    message.values(values);
    message.mask(mask);
    bus_.publish<topic::DigitalOutput>(message);
    run(0.1);
  }
  void motor(std::uint8_t state) {
    msg::MotorPower message;
    message.state(state);
    bus_.publish<topic::MotorPower>(message);
    run(0.02);
  }
  void gains(std::uint8_t type, double p, double i, double d) {
    msg::ControllerInfo message;
    message.type(type);
    message.p_gain(p);
    message.i_gain(i);
    message.d_gain(d);
    bus_.publish<topic::GainsCommand>(message);
    run(0.5);
  }
  SimReader<topic::ControllerInfo> gains_{bus_};
};

TEST_F(CommandTopicsTest, LightsTheLedsInTheColoursOfTheMessageNotOfTheWire) {
  led<topic::Led1>(msg::Led_Constants::GREEN);
  EXPECT_EQ(outputs(), 0x02F0U);
  led<topic::Led1>(msg::Led_Constants::RED);
  EXPECT_EQ(outputs(), 0x01F0U);
  led<topic::Led2>(msg::Led_Constants::ORANGE);
  EXPECT_EQ(outputs(), 0x0DF0U);
  led<topic::Led1>(msg::Led_Constants::BLACK);
  EXPECT_EQ(outputs(), 0x0CF0U);
}

TEST_F(CommandTopicsTest, PlaysEachTuneOnce) {
  sound(4);
  EXPECT_EQ(base_.model.outputs().last_tune, kobuki::Tune::error);
  EXPECT_EQ(base_.model.outputs().sounds, 1U);
  sound(6);
  EXPECT_EQ(base_.model.outputs().last_tune, kobuki::Tune::cleaning_end);
  sound(7);
  EXPECT_EQ(base_.model.outputs().sounds, 2U);
}

TEST_F(CommandTopicsTest, SetsMaskedOutputsOnly) {
  digital({true, true, true, true}, {true, false, true, false});
  EXPECT_EQ(outputs(), 0x00F5U);
  digital({false, false, false, false}, {true, true, false, false});
  EXPECT_EQ(outputs(), 0x00F4U);
}

TEST_F(CommandTopicsTest, SwitchesOneSupplyAndLeavesTheOthers) {
  supply(2, 0);
  EXPECT_EQ(outputs(), 0x00B0U);
  supply(2, 1);
  EXPECT_EQ(outputs(), 0x00F0U);
  for (const int source : {0, 1, 3}) {  // all in one tick
    msg::ExternalPower message;
    message.source(static_cast<std::uint8_t>(source));
    message.state(0);
    bus_.publish<topic::ExternalPower>(message);
  }
  run(0.1);
  EXPECT_EQ(outputs(), 0x0040U);
}

TEST_F(CommandTopicsTest, SetsOutputsOfABaseThatIsAwayWhenItComesBack) {
  base_.plugged = false;
  run(0.2);
  led<topic::Led1>(msg::Led_Constants::GREEN);
  EXPECT_EQ(outputs(), 0x00F0U);
  base_.plugged = true;
  run(1.5);
  EXPECT_EQ(outputs(), 0x02F0U);
}

TEST_F(CommandTopicsTest, ResetsOdometryToTheOrigin) {
  drive(2, 0.3);
  run(1);
  EXPECT_GT(odom_.take().back().pose().pose().position().x(), 0.4);
  bus_.publish<topic::ResetOdometry>({});
  run(0.1);
  EXPECT_NEAR(odom_.take().back().pose().pose().position().x(), 0, 0.01);
  EXPECT_NEAR(imu_.take().back().orientation().z(), 0, 0.01);
}

TEST_F(CommandTopicsTest, StandsWithoutMotorPowerAndWaitsForANewVelocity) {
  drive(1, 0.3);
  motor(0);
  drive(1, 0.3);
  EXPECT_EQ(base_.model.velocity().linear_mps, 0);
  motor(1);
  run(0.4);
  EXPECT_EQ(base_.model.velocity().linear_mps, 0);
  drive(1, 0.3);
  EXPECT_GT(base_.model.velocity().linear_mps, 0.2);
}

TEST_F(CommandTopicsTest, IgnoresColoursSuppliesAndStatesThatAreNone) {
  led<topic::Led1>(4);
  supply(4, 0);
  supply(0, 2);
  EXPECT_EQ(outputs(), 0x00F0U);
  motor(2);
  drive(1, 0.3);
  EXPECT_GT(base_.model.velocity().linear_mps, 0.2);
}

TEST_F(CommandTopicsTest, SetsGainsAndPublishesWhatTheBaseAnswers) {
  const auto known = gains_.take();
  ASSERT_EQ(known.size(), 1U);
  EXPECT_EQ(known[0].type(), 0);
  EXPECT_EQ(known[0].p_gain(), 100);
  EXPECT_EQ(known[0].i_gain(), 0.1);
  EXPECT_EQ(known[0].d_gain(), 2);
  gains(1, 55.5, 0.2, 3);
  EXPECT_EQ(base_.model.outputs().gains.kp_milli, 55500U);
  const auto answered = gains_.take();
  ASSERT_EQ(answered.size(), 1U);
  EXPECT_EQ(answered[0].type(), 1);
  EXPECT_EQ(answered[0].p_gain(), 55.5);
}

TEST_F(CommandTopicsTest, IgnoresGainsThatNoBaseCanHave) {
  gains(1, -1, 0, 0);
  gains(1, 0, NAN, 0);
  gains(1, 0, 0, 4294968);
  gains(2, 1, 1, 1);
  EXPECT_EQ(base_.model.outputs().gains.kp_milli, 100000U);
}

}  // namespace
}  // namespace tocsin
