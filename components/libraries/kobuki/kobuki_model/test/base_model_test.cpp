// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/base_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "foundation/error.hpp"
#include "geometry/pose.hpp"

namespace tocsin::kobuki {
namespace {

const Time t0 = Time{} + seconds(100);

ModelParams exact() {
  ModelParams params;
  params.command_delay_s = 0;
  params.slip_sigma = 0;
  params.gyro_drift_deg_per_sqrt_s = 0;
  params.gyro_noise_dps = 0;
  return params;
}

/// A base with what it has sent.
struct Rig {
  explicit Rig(const ModelParams& params, Surroundings around = open_floor(), int seed = 1)
      : model(params, std::move(around), {}, static_cast<std::uint64_t>(seed), t0) {}

  /// Runs for a time, giving the command every 20 ms if there is one.
  void run(double duration_s, const std::optional<Command>& command = {}) {
    const Time end = now + seconds(duration_s);
    while (now < end) {
      if (command) send(*command);
      now += std::chrono::milliseconds(20);
      model.step(now, [&](Time at, ByteView frame) {
        last_at = at;
        bytes.insert(bytes.end(), frame.begin(), frame.end());
        DecodeCounts counts;
        last = decode_feedback(frame.part(3, frame.size - 4), counts);
        ++frames;
      });
    }
  }
  void send(const Command& command) { model.receive(encode_command(command).bytes(), now); }

  BaseModel model;
  Time now = t0;
  Time last_at;
  Feedback last;
  int frames = 0;
  std::vector<std::uint8_t> bytes;
};

TEST(BaseModel, SendsFiftyFramesASecondHoweverLongItsCallerFroze) {
  Rig sut{exact()};
  sut.run(6);
  EXPECT_EQ(sut.frames, 300);
  EXPECT_EQ(sut.last.core->timestamp_ms, 6000);
  const auto gyro = sut.last.gyro->frame_id;
  int frames = 0;
  sut.model.step(sut.now + seconds(0.2), [&](Time, ByteView) { ++frames; });
  EXPECT_EQ(frames, 10);
  sut.now += seconds(0.2);
  sut.run(0.02);
  EXPECT_EQ(static_cast<std::uint8_t>(sut.last.gyro->frame_id - gyro), 22) << "two a frame";
}

TEST(BaseModel, GivesTheSameBytesForTheSameSeed) {
  Rig a{ModelParams{}, open_floor(), 7};
  Rig b{ModelParams{}, open_floor(), 7};
  Rig c{ModelParams{}, open_floor(), 8};
  for (Rig* rig : {&a, &b, &c}) rig->run(2, BaseControl{200, 500});
  EXPECT_EQ(a.bytes, b.bytes);
  EXPECT_NE(a.bytes, c.bytes);
}

TEST(BaseModel, IsFollowedByOdometryAcrossEncoderWraps) {
  for (const bool gyro : {true, false}) {
    Rig sut{exact()};
    sut.run(0.02);
    OdometryParams params;
    params.use_gyro_heading = gyro;
    Odometry odometry{params};
    for (int i = 0; i < 1500; ++i) {  // 30 s, 12 m
      odometry.update(*sut.last.core, sut.last.inertia);
      sut.run(0.02, BaseControl{400, static_cast<std::int16_t>(i < 700 ? 0 : 900)});
    }
    odometry.update(*sut.last.core, sut.last.inertia);
    EXPECT_NEAR(odometry.pose().x_m, sut.model.pose().x_m, 0.02) << gyro;
    EXPECT_NEAR(odometry.pose().y_m, sut.model.pose().y_m, 0.02) << gyro;
    EXPECT_NEAR(geometry::wrap_angle(odometry.pose().heading_rad - sut.model.pose().heading_rad), 0,
                0.01);
  }
}

TEST(BaseModel, StopsItsWheelsAndPressesItsBumperAtAWall) {
  Rig sut{exact(), walled({{0.6, -5, 0.6, 5, 0}})};
  sut.run(3, BaseControl{300, 0});
  EXPECT_EQ(sut.last.core->bumper, centre_bit);
  const auto left = sut.last.core->left_encoder;
  sut.run(1, BaseControl{300, 0});
  EXPECT_EQ(sut.last.core->left_encoder, left);
  EXPECT_GT(sut.last.current->left, 40);  // the stalled motor draws more
  sut.run(1, BaseControl{-100, 0});
  EXPECT_EQ(sut.last.core->bumper, 0);
}

TEST(BaseModel, AnswersVersionRequestsOnceInTheFormOfItsAge) {
  Rig sut{exact()};
  sut.run(0.1);
  EXPECT_FALSE(sut.last.firmware);
  sut.send(RequestExtra{0x0B});
  sut.run(0.02);
  EXPECT_EQ(to_text(*sut.last.firmware), "1.2.0");
  EXPECT_EQ(to_text(*sut.last.hardware), "1.0.4");
  EXPECT_TRUE(sut.last.unique_id);
  sut.run(0.02);
  EXPECT_FALSE(sut.last.firmware);
  ModelParams params = exact();
  params.firmware = "1.0.0";
  params.old_versions = true;
  Rig old{params};
  old.send(RequestExtra{RequestExtra::firmware});
  old.run(0.02);
  EXPECT_EQ(old.last.firmware->old_code, 123);
  EXPECT_FALSE(old.last.hardware);
}

TEST(BaseModel, HasGainsOnlyFrom120) {
  Rig modern{exact()};
  modern.send(SetGains{{1, 5, 6, 7}});
  modern.send(GetGains{});
  modern.run(0.02);
  EXPECT_EQ(modern.last.gains->kp_milli, 5U);
  ModelParams params = exact();
  params.firmware = "1.1.4";
  Rig old{params};
  old.send(GetGains{});
  old.run(0.02);
  EXPECT_FALSE(old.last.gains);
}

TEST(BaseModel, ShowsOutputsAndSounds) {
  Rig sut{exact()};
  EXPECT_EQ(sut.model.outputs().outputs.bits, OutputRegister::start);
  sut.send(OutputRegister{0x01F0});
  sut.send(Tune::error);
  sut.send(Tone{826, 100});
  EXPECT_EQ(sut.model.outputs().outputs.bits, 0x01F0);
  EXPECT_EQ(sut.model.outputs().last_tune, Tune::error);
  EXPECT_EQ(sut.model.outputs().last_tone->note, 826);
  EXPECT_EQ(sut.model.outputs().sounds, 2U);
}

TEST(BaseModel, ReportsWhatHandsDo) {
  Rig sut{exact()};
  sut.model.inputs().buttons = 2;
  sut.model.inputs().cliff = left_bit;
  sut.model.inputs().wheel_drop = right_bit;
  sut.model.inputs().bumper = right_bit;
  sut.model.power().plug(ChargingSource::adapter);
  sut.run(0.02);
  EXPECT_EQ(sut.last.core->buttons, 2);
  EXPECT_EQ(sut.last.core->cliff, left_bit);
  EXPECT_LT(sut.last.cliff_adc->left, 1000);
  EXPECT_GT(sut.last.cliff_adc->right, 1600);
  EXPECT_EQ(sut.last.core->wheel_drop, right_bit);
  EXPECT_EQ(sut.last.core->bumper, right_bit);
  EXPECT_EQ(sut.last.core->charger, 22);
}

TEST(BaseModel, ReportsGyroBiasAndTurnRate) {
  ModelParams params = exact();
  params.gyro_bias_dps = 0.5;
  Rig sut{params};
  sut.run(10);
  EXPECT_NEAR(sut.last.inertia->angle_cdeg, 500, 2);
  EXPECT_EQ(sut.last.inertia->angle_rate_cdps, 50);
  EXPECT_NEAR(sut.last.gyro->samples[0].z * 0.00875, 0.5, 0.005);
  sut.run(2, BaseControl{115, 1});  // 1 rad/s
  EXPECT_NEAR(sut.last.inertia->angle_rate_cdps, 5730 + 50, 3);
}

TEST(BaseModel, StartsAnewAfterAPowerCycle) {
  Rig sut{exact()};
  sut.run(5, BaseControl{300, 0});
  const auto left = sut.last.core->left_encoder;
  sut.model.power_cycle(sut.now);
  const double x_m = sut.model.pose().x_m;
  sut.run(1);
  EXPECT_NE(sut.last.core->left_encoder, left);
  EXPECT_EQ(sut.last.core->timestamp_ms, 1000);
  EXPECT_EQ(sut.model.pose().x_m, x_m);  // and it stands
}

TEST(BaseModel, ContinuesFromItsMemory) {
  Rig before{exact()};
  before.run(5, BaseControl{300, 800});
  Rig after{exact(), open_floor(), 2};
  after.model.recall(before.model.memory(before.now), t0);
  after.run(0.02);
  EXPECT_EQ(after.last.core->left_encoder, before.last.core->left_encoder);
  EXPECT_EQ(after.last.core->timestamp_ms, before.last.core->timestamp_ms + 20);
  EXPECT_EQ(after.last.inertia->angle_cdeg, before.last.inertia->angle_cdeg);
  EXPECT_NEAR(after.model.pose().x_m, before.model.pose().x_m, 1e-9);
}

TEST(BaseModel, SlipsAwayFromItsEncodersWhichAreNoisyWhenAskedTo) {
  ModelParams params = exact();
  params.slip_sigma = 0.1;
  Rig sut{params};
  sut.run(20, BaseControl{300, 0});
  EXPECT_NE(sut.model.pose().y_m, 0);
  EXPECT_NEAR(sut.model.pose().x_m, 6, 0.3);
  params.encoder_noise_ticks = 3;
  Rig noisy{params};
  std::vector<int> ticks;
  for (int i = 0; i < 100; ++i) {
    noisy.run(0.02);
    ticks.push_back(noisy.last.core->left_encoder);
  }
  const auto [low, high] = std::minmax_element(ticks.begin(), ticks.end());
  EXPECT_GT(*high - *low, 5);
  EXPECT_LT(*high - *low, 40);
}

TEST(BaseModel, MissesItsShareOfTheSignalsOfADock) {
  ModelParams params;
  params.infrared_loss = 0.25;
  BaseModel sut(params, open_floor(), {3, 0, pi}, 1, t0);
  sut.set_dock(Dock({0, 0, 0}));
  int seen = 0;
  DecodeCounts counts;
  sut.step(t0 + seconds(8), [&](Time, ByteView frame) {
    const Feedback feedback = decode_feedback(frame.part(3, frame.size - 4), counts);
    seen += (feedback.dock_infrared->centre & DockInfrared::far_centre) != 0 ? 1 : 0;
  });
  EXPECT_NEAR(seen, 300, 26);  // of 400; 3 deviations
}

TEST(BaseModel, TakesCommandsCutAnywhereAmongNoise) {
  Rig sut{exact()};
  const Frame frame = encode_command(BaseControl{200, 0});
  for (const std::uint8_t noise : std::vector<std::uint8_t>{0xAA, 0x55, 0x99}) {
    sut.model.receive({&noise, 1}, t0);
    for (const std::uint8_t& byte : frame.bytes()) sut.model.receive({&byte, 1}, t0);
  }
  for (int i = 0; i < 30; ++i) sut.send(BaseControl{200, 0});
  sut.run(1);
  EXPECT_GT(sut.model.velocity().linear_mps, 0.19);
}

TEST(BaseModel, RefusesVersionsThatAreNone) {
  ModelParams params;
  for (const char* firmware : {"new", "1.2.0beta"}) {
    params.firmware = firmware;
    EXPECT_THROW(Rig{params}, ConfigError) << firmware;
  }
}

}  // namespace
}  // namespace tocsin::kobuki
