// SPDX-License-Identifier: Apache-2.0
/// The rule: while a stop stands the base stands, whatever else is commanded.
#include <gtest/gtest.h>

#include "model_rig.hpp"

namespace tocsin::kobuki {
namespace {

const geometry::Twist ahead{0.3, 0};

class DriverEmergencyStop : public ::testing::Test {
 protected:
  void SetUp() override { rig.run(1, ahead); }
  void stop(bool stands) { rig.driver.on_emergency_stop(stands, rig.now); }
  [[nodiscard]] bool has_sent_a_velocity() const {
    return std::any_of(rig.commands.begin(), rig.commands.end(), [](const Command& command) {
      const auto* control = std::get_if<BaseControl>(&command);
      return control != nullptr && control->speed_mm_s != 0;
    });
  }
  ModelRig rig;
};

TEST_F(DriverEmergencyStop, SendsNothingButZeroWhoeverCommands) {
  stop(true);
  rig.commands.clear();
  rig.run(5, ahead);
  EXPECT_GE(rig.count<BaseControl>(), 200);
  EXPECT_FALSE(has_sent_a_velocity());
  EXPECT_EQ(rig.model.velocity().linear_mps, 0);
}

TEST_F(DriverEmergencyStop, SendsZeroAtOnceAndNotAtTheNextPeriod) {
  rig.commands.clear();
  stop(true);
  EXPECT_EQ(rig.driver.next_deadline(), rig.now);
  rig.driver.run(rig.now, [&](ByteView bytes) { rig.on_command_bytes(bytes); });
  EXPECT_EQ(rig.count<BaseControl>(), 1);
  EXPECT_FALSE(has_sent_a_velocity());
}

TEST_F(DriverEmergencyStop, ARepetitionOfTheStopCommandsNothingMore) {
  stop(true);
  rig.run(1);
  rig.commands.clear();
  for (int i = 0; i < 1000; ++i) {
    stop(true);
    rig.run(0.001);
  }
  EXPECT_LE(rig.count<BaseControl>(), 51);
}

TEST_F(DriverEmergencyStop, DrivesOnlyByANewVelocityAfterItsRelease) {
  stop(true);
  rig.run(0.3, ahead);
  stop(false);
  rig.commands.clear();
  rig.run(0.5);
  EXPECT_FALSE(has_sent_a_velocity());
  rig.run(1, ahead);
  EXPECT_GT(rig.model.velocity().linear_mps, 0.2);
}

TEST_F(DriverEmergencyStop, StandsFromTheFirstFrameOn) {
  ModelRig fresh;
  fresh.driver.on_emergency_stop(true, fresh.now);
  EXPECT_EQ(fresh.driver.next_deadline(), never) << "no base was heard";
  fresh.run(1, ahead);
  EXPECT_EQ(fresh.model.velocity().linear_mps, 0);
}

TEST_F(DriverEmergencyStop, NeitherMotorPowerNorALossOfThePortReleasesIt) {
  stop(true);
  rig.driver.set_motor_power(false);
  rig.driver.set_motor_power(true);
  rig.run(1, ahead);
  EXPECT_EQ(rig.model.velocity().linear_mps, 0);
  rig.driver.on_port_lost();
  rig.driver.on_port_open();
  rig.run(1, ahead);
  EXPECT_EQ(rig.model.velocity().linear_mps, 0);
  rig.driver.set_motor_power(false);
  stop(false);
  rig.run(1, ahead);
  EXPECT_EQ(rig.model.velocity().linear_mps, 0) << "its release does not switch motor power on";
}

TEST_F(DriverEmergencyStop, RefusesGainsAndDropsThoseThatWait) {
  const ControllerGains gains{1, 9000, 9000, 9000};
  ASSERT_TRUE(rig.driver.set_gains(gains));
  stop(true);
  EXPECT_FALSE(rig.driver.set_gains(gains));
  rig.run(1);
  EXPECT_NE(rig.model.outputs().gains.kp_milli, gains.kp_milli);
  stop(false);
  EXPECT_TRUE(rig.driver.set_gains(gains));
  rig.run(1);
  EXPECT_EQ(rig.model.outputs().gains.kp_milli, gains.kp_milli);
}

TEST_F(DriverEmergencyStop, LampsAndSoundsGoOn) {
  stop(true);
  OutputRegister outputs = rig.driver.outputs();
  outputs.set_led(1, true, false);
  rig.driver.set_outputs(outputs);
  EXPECT_TRUE(rig.driver.send_once(Tune::error));
  rig.run(0.1);
  EXPECT_EQ(rig.model.outputs().outputs.bits, outputs.bits);
  EXPECT_EQ(rig.model.outputs().last_tune, Tune::error);
}

}  // namespace
}  // namespace tocsin::kobuki
