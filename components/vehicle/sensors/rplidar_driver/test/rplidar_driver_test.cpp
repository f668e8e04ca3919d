// SPDX-License-Identifier: Apache-2.0
#include "rplidar_driver/rplidar_driver.hpp"

#include <gtest/gtest.h>

#include <random>

#include "rplidar_protocol/rplidar_model.hpp"

namespace tocsin::rplidar {
namespace {

class RplidarDriverTest : public ::testing::Test {
 protected:
  void SetUp() override { sut_.on_port_open(now_); }
  void pass(double s) {
    for (const Time end = now_ + seconds(s); now_ < end; now_ += std::chrono::milliseconds(5)) {
      model_.step(now_, [this](ByteView bytes) { arrive(bytes); });
      sut_.run(now_, [this](const Bytes& bytes) {
        sent_.push_back(bytes);
        if (hears_) model_.receive({bytes.data(), bytes.size()}, now_);
      });
    }
  }
  void arrive(ByteView bytes) {
    if (!speaks_) return;
    Bytes copy(bytes.begin(), bytes.end());
    if (damage_ > 0) {
      for (auto& byte : copy) {
        if (random_() % 1000 < damage_) byte = static_cast<std::uint8_t>(random_());
      }
    }
    sut_.on_bytes({copy.data(), copy.size()}, now_,
                  [this](const Turn& turn) { turns_.push_back(turn); });
  }
  [[nodiscard]] int resets() const {
    return static_cast<int>(std::count(sent_.begin(), sent_.end(), request(Command::reset)));
  }

  Time now_ = Time() + std::chrono::hours(1);
  RplidarModel model_{ModelParams{}, [](double, Time) { return RplidarModel::Look{2, 47}; }, now_};
  RplidarDriver sut_{RplidarDriver::Params{}};
  std::vector<Bytes> sent_;
  std::vector<Turn> turns_;
  bool hears_ = true;
  bool speaks_ = true;
  unsigned damage_ = 0;     ///< in 1000 bytes
  std::mt19937 random_{1};  // NOLINT: a fixed seed is the point
};

TEST_F(RplidarDriverTest, AsksWhoAndHowItIsThenScans) {
  pass(3);
  EXPECT_EQ(sut_.state(), LaserState::scanning);
  ASSERT_TRUE(sut_.info());
  EXPECT_EQ(sut_.info()->model, 0x18);
  EXPECT_EQ(resets(), 0);
  turns_.clear();
  pass(2);
  EXPECT_NEAR(static_cast<double>(turns_.size()), 11, 1);
  EXPECT_NEAR(sut_.turn_hz(), 5.5, 0.1);
  for (const float range : turns_.back().ranges_m) EXPECT_NEAR(range, 2, 1e-3);
}

TEST_F(RplidarDriverTest, ScansExpressWhenAsked) {
  RplidarDriver::Params params;
  params.express = true;
  sut_ = RplidarDriver(params);
  sut_.on_port_open(now_);
  pass(4);
  EXPECT_EQ(sut_.state(), LaserState::scanning);
  EXPECT_GT(turns_.size(), 5U);
}

TEST_F(RplidarDriverTest, AMotorThatStallsIsToldAndScansAgainWhenFreed) {
  pass(3);
  model_.stall(true, now_);
  pass(2.2);
  EXPECT_EQ(sut_.state(), LaserState::stalled);
  turns_.clear();
  pass(20);
  EXPECT_TRUE(turns_.empty());
  EXPECT_LE(resets(), 5) << "with pauses that double";
  model_.stall(false, now_);
  pass(20);
  EXPECT_EQ(sut_.state(), LaserState::scanning);
}

TEST_F(RplidarDriverTest, AnErrorOfItsHealthIsToldAndItIsStartedAnew) {
  model_.set_health({Health::Status::error, 9});
  pass(1);
  EXPECT_EQ(sut_.state(), LaserState::unhealthy);
  EXPECT_EQ(sut_.health()->code, 9);
  EXPECT_GE(resets(), 1);
  model_.set_health({Health::Status::warning, 9});
  pass(8);
  EXPECT_EQ(sut_.state(), LaserState::scanning);
}

/// A wrong baud rate, another device, a dead one.
TEST_F(RplidarDriverTest, WhatIsNoLaserIsSilentHoweverMuchItSends) {
  hears_ = false;
  pass(1);
  EXPECT_EQ(sut_.state(), LaserState::silent);
  for (int i = 0; i < 1000; ++i) {
    Bytes noise(100);
    for (auto& byte : noise) byte = static_cast<std::uint8_t>(random_());
    arrive({noise.data(), noise.size()});
    pass(0.01);
  }
  EXPECT_TRUE(turns_.empty());
  EXPECT_NE(sut_.state(), LaserState::scanning);
  hears_ = true;
  pass(15);
  EXPECT_EQ(sut_.state(), LaserState::scanning);
}

TEST_F(RplidarDriverTest, ScansOnThroughDamagedBytesAndGivesFewWrongRanges) {
  pass(3);
  turns_.clear();
  damage_ = 5;
  pass(10);
  EXPECT_EQ(sut_.state(), LaserState::scanning);
  EXPECT_GT(turns_.size(), 45U);
  std::size_t beams = 0;
  std::size_t wrong = 0;
  for (const Turn& turn : turns_) {
    for (const float range : turn.ranges_m) {
      ++beams;
      wrong += std::isfinite(range) && std::abs(range - 2) > 0.01 ? 1U : 0U;
    }
  }
  EXPECT_LT(static_cast<double>(wrong), 0.012 * static_cast<double>(beams))
      << "ranges have no check bits";
}

TEST_F(RplidarDriverTest, AScanThatFallsSilentBeginsAgain) {
  pass(3);
  speaks_ = false;
  pass(2.5);
  EXPECT_NE(sut_.state(), LaserState::scanning);
  speaks_ = true;
  pass(10);
  EXPECT_EQ(sut_.state(), LaserState::scanning);
}

TEST_F(RplidarDriverTest, APulledCableIsToldAndANewOneScans) {
  pass(3);
  sut_.on_port_lost();
  EXPECT_EQ(sut_.state(), LaserState::no_port);
  EXPECT_EQ(sut_.deadline(), never);
  sent_.clear();
  pass(1);
  EXPECT_TRUE(sent_.empty());
  sut_.on_port_open(now_);
  pass(3);
  EXPECT_EQ(sut_.state(), LaserState::scanning);
}

}  // namespace
}  // namespace tocsin::rplidar
