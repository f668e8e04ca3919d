// SPDX-License-Identifier: Apache-2.0
/// The component and its port: absent, lost, occupied, without a descriptor, restarted.
#include <gmock/gmock.h>

#include <cstdio>

#include "component_rig.hpp"
#include "foundation/error.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using KobukiDriverPortTest = KobukiDriverComponentTest;

TEST_F(KobukiDriverPortTest, ReadsAPortWithoutADescriptorWhenItsBytesCome) {
  sut_ = std::make_unique<KobukiDriverComponent>(context_, params_);
  bus_.add(*sut_);
  bus_.run_for(seconds(0.03));
  odom_.take();
  bus_.run_for(seconds(0.02));
  EXPECT_TRUE(odom_.take().empty());  // nobody told that bytes wait
  devices_.readable();
  bus_.run_for(seconds(0.001));
  EXPECT_FALSE(odom_.take().empty());
}

TEST_F(KobukiDriverPortTest, WaitsForAnAbsentPort) {
  base_.plugged = false;
  start();
  run(3);
  EXPECT_NEAR(devices_.attempts, 7, 1);  // at start and every 0.5 s
  EXPECT_TRUE(odom_.take().empty());
  base_.plugged = true;
  run(1);
  EXPECT_GT(odom_.take().size(), 20U);
}

TEST_F(KobukiDriverPortTest, EndsWhenAnotherProcessHasThePort) {
  devices_.in_use = "/dev/kobuki is in use by minicom (pid 7)";
  devices_.held = true;
  try {
    KobukiDriverComponent sut(context_, params_);
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("kobuki_driver.device_port: /dev/kobuki is in use by minicom"));
  }
  devices_.held = false;
  EXPECT_NO_THROW(KobukiDriverComponent(context_, params_)) << "it outlasts what nobody holds";
}

TEST_F(KobukiDriverPortTest, GoesOnWhereAKilledDriverWas) {
  context_.run_dir = ::testing::TempDir();
  for (const double dead_s : {0.4, 5.0}) {
    std::remove((context_.run_dir + "/kobuki_driver.odometry").c_str());
    base_.model.place({});
    start();
    drive(3, 0.3);
    sut_.reset();  // the base rolls out meanwhile
    base_.model.step(bus_.now() + seconds(dead_s) - std::chrono::milliseconds(100),
                     [](Time, ByteView) {});
    run(dead_s);
    odom_.take();
    start();
    run(1);
    EXPECT_NEAR(odom_.take().back().pose().pose().position().x(), base_.model.pose().x_m, 0.02);
  }
  std::remove((context_.run_dir + "/kobuki_driver.odometry").c_str());
}

TEST_F(KobukiDriverPortTest, ThePoseGoesOnWithoutAJumpAfterTheCableWasPulled) {
  start();
  drive(3, 0.3);
  base_.plugged = false;
  run(1);
  base_.plugged = true;
  odom_.take();
  run(1);
  const auto poses = odom_.take();
  ASSERT_GT(poses.size(), 10U);
  double last_m = poses.front().pose().pose().position().x();
  for (const auto& odom : poses) {
    EXPECT_LT(odom.pose().pose().position().x() - last_m, 0.03);
    last_m = odom.pose().pose().position().x();
  }
}

}  // namespace
}  // namespace tocsin
