// SPDX-License-Identifier: Apache-2.0
#include "rplidar_protocol/rplidar_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/numbers.hpp"
#include "rplidar_protocol/decoder.hpp"

namespace tocsin::rplidar {
namespace {

/// A device in a room: what it sees is 2 m and a part that tells the direction.
class Device {
 public:
  explicit Device(const ModelParams& params = {}) : model(params, eye, now) {}

  void ask(const Bytes& bytes) { model.receive({bytes.data(), bytes.size()}, now); }
  void pass(double s) {
    for (const Time end = now + seconds(s); now < end; now += std::chrono::milliseconds(5)) {
      model.step(now, [this](ByteView bytes) {
        decoder.feed(bytes, [this](const Answer& answer) { answers.push_back(answer); });
      });
    }
  }
  [[nodiscard]] std::vector<Reading> readings() const {
    std::vector<Reading> found;
    for (const Answer& one : answers) {
      if (const auto* reading = std::get_if<Reading>(&one)) found.push_back(*reading);
    }
    return found;
  }
  static RplidarModel::Look eye(double bearing_rad, Time) { return {2 + bearing_rad / 4, 47}; }

  Time now = Time() + std::chrono::hours(1);
  RplidarModel model;
  Decoder decoder;
  std::vector<Answer> answers;
};

TEST(RplidarModel, ScansCounterToItsOwnAnglesAtItsRate) {
  Device sut;
  sut.pass(1);
  sut.ask(request(Command::scan));
  sut.pass(2);
  const auto readings = sut.readings();
  EXPECT_NEAR(static_cast<double>(readings.size()), 4000, 50);
  int turns = 0;
  for (const Reading& one : readings) {
    turns += one.begins_turn ? 1 : 0;
    const double bearing_rad = std::remainder(-one.angle_rad, 2 * pi);
    EXPECT_NEAR(one.range_m, 2 + bearing_rad / 4, 1e-3);
  }
  EXPECT_NEAR(turns, 11, 1);
  EXPECT_EQ(sut.decoder.counts().discarded, 0U);
}

TEST(RplidarModel, AnExpressScanHasTwiceTheReadings) {
  Device sut;
  sut.pass(1);
  sut.ask(request(Command::express_scan));
  sut.pass(2);
  const auto readings = sut.readings();
  EXPECT_NEAR(static_cast<double>(readings.size()), 8000, 150);
  for (const Reading& one : readings) {
    const double bearing_rad = std::remainder(-one.angle_rad, 2 * pi);
    if (std::abs(bearing_rad) < 3) {
      EXPECT_NEAR(one.range_m, 2 + bearing_rad / 4, 5e-3);
    }
  }
}

TEST(RplidarModel, SaysNothingUntilItsMotorTurns) {
  ModelParams a2;
  a2.motor_by_request = true;
  Device sut(a2);
  sut.ask(request(Command::scan));
  sut.pass(1.5);
  EXPECT_TRUE(sut.readings().empty()) << "the motor stands";
  sut.ask(motor_request(660));
  sut.pass(1.5);
  EXPECT_FALSE(sut.readings().empty());
  sut.answers.clear();
  sut.model.stall(true, sut.now);
  sut.pass(1);
  EXPECT_LT(sut.readings().size(), 50U);
  sut.answers.clear();
  sut.model.stall(false, sut.now);
  sut.pass(2);
  EXPECT_FALSE(sut.readings().empty());
}

TEST(RplidarModel, AnErrorOfHealthAllowsNoScan) {
  Device sut;
  sut.model.set_health({Health::Status::error, 3});
  sut.ask(request(Command::get_health));
  sut.ask(request(Command::scan));
  sut.pass(2);
  ASSERT_EQ(sut.answers.size(), 1U);
  EXPECT_EQ(std::get<Health>(sut.answers[0]).code, 3);
}

TEST(RplidarModel, ARequestEndsTheScanAndAResetGreets) {
  Device sut;
  sut.pass(1);
  sut.ask(request(Command::scan));
  sut.pass(0.5);
  sut.ask(request(Command::reset));
  EXPECT_FALSE(sut.model.is_scanning());
  sut.ask(request(Command::get_info));
  sut.answers.clear();
  sut.pass(0.4);
  EXPECT_TRUE(sut.answers.empty()) << "deaf while it starts";
  sut.pass(0.5);
  EXPECT_GT(sut.decoder.counts().discarded, 20U) << "its greeting";
  sut.ask(request(Command::get_info));
  sut.pass(0.1);
  ASSERT_FALSE(sut.answers.empty());
  EXPECT_EQ(std::get<Info>(sut.answers.back()).model, 0x18);
}

TEST(RplidarModel, OutsideOfItsViewNothingReturns) {
  ModelParams kinect;
  kinect.first_rad = -0.5;
  kinect.view_rad = 1;
  Device sut(kinect);
  sut.pass(1);
  sut.ask(request(Command::scan));
  sut.pass(1);
  for (const Reading& one : sut.readings()) {
    const double bearing_rad = std::remainder(-one.angle_rad, 2 * pi);
    if (std::abs(bearing_rad) > 0.501) {
      EXPECT_EQ(one.range_m, 0) << bearing_rad;
    }
    if (std::abs(bearing_rad) < 0.499) {
      EXPECT_GT(one.range_m, 0) << bearing_rad;
    }
  }
}

}  // namespace
}  // namespace tocsin::rplidar
