// SPDX-License-Identifier: Apache-2.0
#include "sim_laser.hpp"

#include <gtest/gtest.h>

#include <array>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"
#include "rplidar_protocol/decoder.hpp"

namespace tocsin::simulation {
namespace {

class SimLaserTest : public ::testing::Test {
 protected:
  /// Readings of so many simulated seconds.
  std::size_t run(double s) {
    const std::size_t before = decoder_.counts().readings;
    for (const Time end = core_.now + seconds(s); core_.now < end;) {
      core_.now =
          std::min(end, std::max(core_.now + std::chrono::milliseconds(1), sut_.next_event()));
      sut_.advance({});
    }
    return decoder_.counts().readings - before;
  }
  void open() {
    port_ = sut_.open([this] {
      std::array<std::uint8_t, 4096> bytes{};
      const auto count = port_->read(bytes.data(), bytes.size());
      decoder_.feed({bytes.data(), count.value_or(0)}, [](const rplidar::Answer&) {});
    });
  }
  void scan() {
    const auto ask = rplidar::request(rplidar::Command::scan);
    EXPECT_TRUE(port_->write(ask.data(), ask.size()));
  }

  Core core_;
  std::shared_ptr<laser::Scene> scene_ =
      std::make_shared<laser::Scene>(std::vector<geometry::Wall>{{2, -1, 2, 1, 0}});
  SimLaser sut_{core_, {"/dev/rplidar", "rplidar_a1", {}}, scene_, 1};
  std::unique_ptr<SerialDevice> port_;
  rplidar::Decoder decoder_;
};

TEST_F(SimLaserTest, MeasuresForWhoeverHasItOpen) {
  EXPECT_EQ(sut_.next_event(), never);
  open();
  run(1);
  scan();
  EXPECT_NEAR(static_cast<double>(run(1)), 2000, 60);
  port_.reset();
  EXPECT_EQ(sut_.next_event(), never) << "nobody reads";
  open();
  run(1);
  scan();
  EXPECT_GT(run(1), 1900U);
}

TEST_F(SimLaserTest, IsDeadUntilItIsPluggedInAgainAndOpenedAnew) {
  open();
  scan();
  const Fault dead{FaultKind::laser_dead, 0, 1, "", 0};
  sut_.begin(dead);
  EXPECT_EQ(run(1), 0U);
  EXPECT_FALSE(sut_.open([] {}));
  std::uint8_t byte = 0;
  EXPECT_FALSE(port_->read(&byte, 1)) << "lost";
  EXPECT_FALSE(port_->write(&byte, 1)) << "lost";
  sut_.end(dead);
  EXPECT_FALSE(port_->read(&byte, 1)) << "lost for good";
  open();
  run(1);
  scan();
  EXPECT_GT(run(1), 1900U);
}

TEST_F(SimLaserTest, IsLate) {
  open();
  run(1);
  sut_.begin({FaultKind::laser_late, 0, 1, "", 0.5});
  scan();
  EXPECT_EQ(run(0.49), 0U);
  EXPECT_GT(run(0.5), 900U);
}

TEST_F(SimLaserTest, OfAnUnknownKindIsRefused) {
  EXPECT_THROW(SimLaser(core_, {"/dev/rplidar", "sonar", {}}, scene_, 1), ConfigError);
}

}  // namespace
}  // namespace tocsin::simulation
