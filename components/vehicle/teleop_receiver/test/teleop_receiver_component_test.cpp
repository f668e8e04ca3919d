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

  SimBus bus_;
  Context context_{bus_, "teleop_receiver", Role::uxv};
  SimReader<topic::CmdVelTeleop> commands_{bus_};
  TeleopReceiverComponent sut_{context_, {}};
};

TEST_F(TeleopReceiverComponentTest, PassesFreshCommandsUnchanged) {
  receive(0.3, 0.02);
  const auto all = commands_.take();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].linear().x(), 0.3);
  EXPECT_EQ(all[0].angular().z(), -0.5);
}

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
  receive(0.3, 100, "gamepad");
  EXPECT_EQ(commands_.take().size(), 2U);
}

TEST_F(TeleopReceiverComponentTest, SaysNothingOfItsOwn) {
  receive(0.3, 0.02);
  commands_.take();
  bus_.run_for(seconds(10));
  EXPECT_TRUE(commands_.take().empty());
}

}  // namespace
}  // namespace tocsin
