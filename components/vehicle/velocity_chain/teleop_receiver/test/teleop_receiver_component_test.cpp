// SPDX-License-Identifier: Apache-2.0
#include "teleop_receiver/teleop_receiver_component.hpp"

#include <gtest/gtest.h>

#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

class TeleopReceiverComponentTest : public ::testing::Test {
 protected:
  TeleopReceiverComponentTest() { bus_.add(sut_); }
  /// A command that was `delay_s` on its way.
  void receive(double linear_mps, double delay_s, const std::string& device = "keyboard") {
    const std::int64_t sent_ns =
        bus_.wall_ns(bus_.now()) - static_cast<std::int64_t>(delay_s * 1e9);
    topic::TeleopCmdVel::Message message;
    message.header().frame_id(device);
    message.header().stamp().sec(static_cast<std::int32_t>(sent_ns / 1'000'000'000));
    message.header().stamp().nanosec(static_cast<std::uint32_t>(sent_ns % 1'000'000'000));
    message.twist().linear().x(linear_mps);
    message.twist().angular().z(-0.5);
    bus_.publish<topic::TeleopCmdVel>(message);
    bus_.run_for(seconds(0.1));
  }

  void request(const std::string& name, const std::string& verb) {
    topic::DriverRequest::Message message;
    message.name(name);
    message.verb(verb);
    bus_.publish<topic::DriverRequest>(message);
    bus_.run_for(seconds(0.1));
  }

  SimBus bus_;
  Context context_{bus_, "teleop_receiver", Role::uxv};
  SimReader<topic::CmdVelTeleop> commands_{bus_};
  SimReader<topic::DriverState> states_{bus_};
  TeleopReceiverComponent sut_{context_, {}};
};

TEST_F(TeleopReceiverComponentTest, DropsACommandThatWasTooLongOnItsWay) {
  receive(0.3, 0.02);
  receive(0.3, 0.52);
  EXPECT_EQ(commands_.take().size(), 2U);
  receive(0.3, 0.521);
  EXPECT_TRUE(commands_.take().empty());
  receive(0, 0.02);
  EXPECT_EQ(commands_.take().size(), 1U);
}

TEST_F(TeleopReceiverComponentTest, JudgesEachDeviceByItsOwnClock) {
  receive(0.3, 0.02, "keyboard");
  bus_.run_for(seconds(2));
  commands_.take();
  receive(0.3, 100, "gamepad");
  EXPECT_EQ(commands_.take().size(), 1U);
}

TEST_F(TeleopReceiverComponentTest, FollowsOneDriverAndTellsWhom) {
  receive(0.3, 0.02, "anna");
  receive(0.2, 0.02, "ben");
  const auto followed = commands_.take();
  ASSERT_EQ(followed.size(), 1U);
  EXPECT_EQ(followed[0].linear().x(), 0.3);
  EXPECT_EQ(followed[0].angular().z(), -0.5);
  ASSERT_FALSE(states_.take().empty());
  bus_.run_for(seconds(1));
  const auto told = states_.take();
  ASSERT_EQ(told.size(), 1U) << "once a second";
  EXPECT_EQ(told[0].driver(), "anna");
  EXPECT_EQ(told[0].refused(), 1U);
}

TEST_F(TeleopReceiverComponentTest, HandsOverToWhoAsksAndLeavesTheVehicleStandingBetween) {
  receive(0.3, 0.02, "anna");
  request("ben", "ask");
  EXPECT_EQ(states_.take().back().asked_by(), "ben");
  request("anna", "keep");
  EXPECT_EQ(states_.take().back().asked_by(), "");
  request("ben", "grab it");
  EXPECT_TRUE(states_.take().empty());
  request("ben", "ask");
  commands_.take();
  request("anna", "give");
  const auto sent = commands_.take();
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent[0].linear().x(), 0);
  EXPECT_EQ(states_.take().back().driver(), "ben");
  receive(0.3, 0.02, "anna");
  EXPECT_TRUE(commands_.take().empty());
  receive(0.2, 0.02, "ben");
  EXPECT_EQ(commands_.take().size(), 1U);
}

TEST_F(TeleopReceiverComponentTest, TellsThatNobodyDrivesAnyMoreAndIsSilentThen) {
  receive(0.3, 0.02, "anna");
  bus_.run_for(seconds(3));
  EXPECT_EQ(states_.take().back().driver(), "");
  bus_.run_for(seconds(60));
  EXPECT_TRUE(states_.take().empty());
}

TEST_F(TeleopReceiverComponentTest, SaysNothingOfItsOwn) {
  receive(0.3, 0.02);
  commands_.take();
  bus_.run_for(seconds(10));
  EXPECT_TRUE(commands_.take().empty());
}

}  // namespace
}  // namespace tocsin
