// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/kobuki_driver.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model_rig.hpp"

namespace tocsin::kobuki {
namespace {

BaseControl last_velocity(const ModelRig& rig) {
  BaseControl last{-1, -1};
  for (const Command& command : rig.commands) {
    if (const auto* control = std::get_if<BaseControl>(&command)) last = *control;
  }
  return last;
}

TEST(KobukiDriver, SendsNothingBeforeTheFirstGoodFrame) {
  ModelRig sut;
  sut.silent = true;
  sut.run(2, geometry::Twist{0.3, 0});
  EXPECT_TRUE(sut.commands.empty());
  EXPECT_EQ(sut.driver.next_deadline(), never);
}

TEST(KobukiDriver, CommandsFiftyTimesASecondAlsoWhenTheBaseFallsSilent) {
  ModelRig sut;
  sut.run(0.1);
  for (const bool silent : {false, true}) {
    sut.silent = silent;
    sut.commands.clear();
    sut.run(10);
    EXPECT_NEAR(sut.count<BaseControl>(), 500, 2);
    EXPECT_EQ(sut.count<OutputRegister>(), 0) << "supplies are never cut by itself";
  }
}

TEST(KobukiDriver, ReadsEveryFrameAtAnyLatency) {
  for (const int ms : {1, 2, 4, 8, 16}) {
    LineParams line;
    line.usb_latency_ms = ms;
    ModelRig sut({}, exact_model(), line);
    sut.run(6.03);
    EXPECT_GE(sut.readings, 300) << ms;
    EXPECT_EQ(sut.driver.frame_counts().rejected, 0U) << ms;
    EXPECT_EQ(sut.driver.state(), BaseState::online) << ms;
  }
}

TEST(KobukiDriver, StopsWhenVelocitiesGoStale) {
  ModelRig sut;
  sut.run(1, geometry::Twist{0.5, 0});
  const double x_m = sut.model.pose().x_m;
  sut.run(2);
  EXPECT_EQ(sut.model.velocity().linear_mps, 0);
  const double stopping_m = sut.model.pose().x_m - x_m;
  EXPECT_LT(stopping_m, 0.5 * 0.65 + 0.02);
  EXPECT_GT(stopping_m, 0.2);
}

TEST(KobukiDriver, IsOfflineWithin200MsOfSilence) {
  ModelRig sut;
  sut.run(1, geometry::Twist{0.3, 0});
  sut.silent = true;
  sut.run(0.13);
  EXPECT_EQ(sut.driver.state(), BaseState::online);
  sut.run(0.07);
  EXPECT_EQ(sut.driver.state(), BaseState::silent);
  EXPECT_EQ(last_velocity(sut).speed_mm_s, 0);
}

TEST(KobukiDriver, ResumesDrivingOnlyByANewCommand) {
  ModelRig sut;
  sut.run(1, geometry::Twist{0.3, 0});
  sut.silent = true;
  sut.run(0.25);
  sut.silent = false;
  sut.run(0.2);
  EXPECT_EQ(sut.driver.state(), BaseState::online);
  EXPECT_EQ(last_velocity(sut).speed_mm_s, 0);  // the reference drives on by itself
  sut.run(0.2, geometry::Twist{0.3, 0});
  EXPECT_EQ(last_velocity(sut).speed_mm_s, 300);
}

TEST(KobukiDriver, KeepsOdometryOverShortAndLongSilence) {
  for (const double gap_s : {1.0, 2.9, 3.1, 8.0, 70.0}) {
    ModelParams base = exact_model();
    base.command_timeout_s = 0.5;
    ModelRig sut({}, base);
    sut.run(2, geometry::Twist{0.3, 0.2});
    sut.silent = true;
    sut.connected = false;
    sut.run(gap_s);
    sut.silent = false;
    sut.connected = true;
    sut.run(2, geometry::Twist{0.3, 0.2});
    EXPECT_EQ(sut.driver.odometry().rejected_jumps(), 0U);
    EXPECT_NEAR(sut.last.pose.x_m, sut.model.pose().x_m, 0.02) << gap_s;
    EXPECT_NEAR(sut.last.pose.y_m, sut.model.pose().y_m, 0.02) << gap_s;
  }
}

TEST(KobukiDriver, TellsThatAPoseIsOldUntilTheFrameAfterASilenceIsConfirmed) {
  ModelRig sut;
  sut.run(2, geometry::Twist{0.3, 0});
  EXPECT_FALSE(sut.last.pose_is_old);
  sut.silent = true;
  sut.run(1);
  sut.silent = false;
  const int before = sut.readings;
  while (sut.readings == before) sut.run(0.001);
  EXPECT_TRUE(sut.last.pose_is_old);
  while (sut.readings == before + 1) sut.run(0.001);
  EXPECT_FALSE(sut.last.pose_is_old);
}

TEST(KobukiDriver, KeepsABaseOfAnotherProtocolStanding) {
  for (const char* firmware : {"0.9.0", "2.0.0"}) {
    ModelParams base = exact_model();
    base.firmware = firmware;
    ModelRig sut({}, base);
    sut.run(1, geometry::Twist{0.3, 0});
    EXPECT_EQ(sut.driver.state(), BaseState::refused);
    sut.commands.clear();
    sut.run(1, geometry::Twist{0.3, 0});
    EXPECT_EQ(last_velocity(sut).speed_mm_s, 0);
    EXPECT_EQ(sut.model.velocity().linear_mps, 0);
  }
}

// Noise that passes the checksum must not keep a good base standing.
TEST(KobukiDriver, AsksARefusedBaseAgainAndDrivesOnWhenItWasNoise) {
  ModelRig sut;
  ASSERT_TRUE(sut.model.set_versions("1.0.4", "2.0.0", false));
  sut.run(1, geometry::Twist{0.3, 0});
  ASSERT_EQ(sut.driver.state(), BaseState::refused);
  ASSERT_TRUE(sut.model.set_versions("1.0.4", "1.2.0", false));
  sut.run(3, geometry::Twist{0.3, 0});
  EXPECT_EQ(sut.driver.state(), BaseState::online);
  EXPECT_NEAR(sut.model.velocity().linear_mps, 0.3, 0.01);
  const int asked = sut.count<RequestExtra>();
  sut.run(30);
  EXPECT_EQ(sut.count<RequestExtra>(), asked);
}

TEST(KobukiDriver, SurvivesAPowerCycleOfTheBase) {
  ModelRig sut;
  sut.run(2, geometry::Twist{0.3, 0.2});
  const geometry::Pose before = sut.last.pose;
  sut.model.power_cycle(sut.now);
  sut.run(0.5);
  EXPECT_NEAR(sut.last.pose.x_m, before.x_m, 0.2);
  EXPECT_NEAR(sut.last.pose.y_m, before.y_m, 0.2);
}

TEST(KobukiDriver, SendsTheOutputRegisterAgainAfterAReconnection) {
  ModelRig sut;
  sut.run(0.1);
  OutputRegister outputs;
  outputs.set_led(1, false, true);
  sut.driver.set_outputs(outputs);
  sut.run(0.1);
  EXPECT_EQ(sut.model.outputs().outputs.bits, 0x02F0);
  sut.model.power_cycle(sut.now);
  EXPECT_EQ(sut.model.outputs().outputs.bits, 0x00F0);
  sut.driver.on_port_lost();
  sut.driver.on_port_open();
  sut.run(0.2);
  EXPECT_EQ(sut.model.outputs().outputs.bits, 0x02F0);
}

TEST(KobukiDriver, SendsSoundsOnceAndBoundsTheQueue) {
  ModelRig sut;
  EXPECT_FALSE(sut.driver.send_once(Tune::on));  // nobody is there yet
  sut.run(0.1);
  EXPECT_TRUE(sut.driver.send_once(Tune::error));
  sut.run(1);
  EXPECT_EQ(sut.count<Tune>(), 1);
  int taken = 0;
  for (int i = 0; i < 1000; ++i) taken += sut.driver.send_once(Tone{826, 10});
  EXPECT_EQ(taken, 16);
}

TEST(KobukiDriver, SaysFarewellWithZeroVelocity) {
  ModelRig sut;
  sut.run(1, geometry::Twist{0.3, 0});
  sut.commands.clear();
  sut.driver.farewell([&](ByteView bytes) { sut.on_command_bytes(bytes); });
  EXPECT_EQ(sut.count<BaseControl>(), 3);
  EXPECT_EQ(last_velocity(sut).speed_mm_s, 0);
  EXPECT_EQ(last_velocity(sut).radius_mm, 0);
}

TEST(KobukiDriver, SendsOneCommandAfterAFreezeNotMany) {
  ModelRig sut;
  sut.run(0.5);
  sut.commands.clear();
  sut.now += std::chrono::milliseconds(160);
  sut.step();
  EXPECT_EQ(sut.count<BaseControl>(), 1);
  EXPECT_EQ(sut.driver.state(), BaseState::online);  // the bytes that waited are read first
}

TEST(KobukiDriver, TurnsByItsOwnWheelSeparation) {
  KobukiDriver::Params params;
  params.odometry.wheel_separation_m = 0.253;  // 10 % more than nominal
  ModelRig sut(params);
  sut.run(1, geometry::Twist{0, 1.0});
  EXPECT_EQ(last_velocity(sut).radius_mm, 1);
  EXPECT_NEAR(last_velocity(sut).speed_mm_s, 126.5, 0.6);
}

TEST(KobukiDriver, ReadsOnThroughNoise) {
  LineParams line;
  line.flip_probability = line.loss_probability = line.noise_probability = 0.0005;
  ModelRig sut({}, exact_model(), line);
  sut.run(60, geometry::Twist{0.2, 0.3});
  EXPECT_GT(sut.readings, 2500);
  EXPECT_GT(sut.driver.frame_counts().rejected, 0U);
  EXPECT_NEAR(sut.last.pose.x_m, sut.model.pose().x_m, 0.05);
}

TEST(KobukiDriver, ForgetsTheVelocityWhenThePortIsLost) {
  ModelRig sut;
  sut.run(1, geometry::Twist{0.3, 0});
  sut.driver.on_port_lost();
  EXPECT_EQ(sut.driver.state(), BaseState::no_port);
  EXPECT_EQ(sut.driver.next_deadline(), never);
  sut.driver.on_port_open();
  sut.commands.clear();
  sut.run(0.3);
  EXPECT_EQ(last_velocity(sut).speed_mm_s, 0);
}

}  // namespace
}  // namespace tocsin::kobuki
