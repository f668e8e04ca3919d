// SPDX-License-Identifier: Apache-2.0
// The emergency stop on the vehicle's own host: the driver holds it against everybody there, and
// people press and release it there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <string>
#include <vector>

#include "emergency_stop_rig.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;
using ::testing::HasSubstr;

/// Orders for its own run only, whatever else runs on this computer.
class DriverStopTest : public EmergencyStopTest {
 protected:
  int own_estop(std::vector<std::string> words) {
    words.insert(words.end(), {"--run-dir", stack_->folder()});
    return estop(words);
  }
};

TEST_F(DriverStopTest, HoldsWhoeverPublishesVelocitiesOnTheVehiclesHost) {
  drive();
  ASSERT_EQ(own_estop({"on"}), 0) << said();
  const Peer rogue(stack_->running("uxv/recorder"), on_host(domain), drive_past_all());
  EXPECT_TRUE(stands(5));
  const pid_t before = stack_->pid("uxv/drive");
  kill(before, SIGKILL);
  ASSERT_TRUE(Stack::eventually(seconds(10), [&] {
    const pid_t now = stack_->pid("uxv/drive");
    return now != 0 && now != before;
  }));
  EXPECT_TRUE(stands(5)) << "the driver of another process keeps it, too";
  EXPECT_EQ(own_estop({"off"}), 0) << said();
  EXPECT_TRUE(moves());
}

TEST_F(DriverStopTest, IsPressedAndReleasedOnTheVehiclesOwnHost) {
  drive();
  EXPECT_EQ(own_estop({"on", "--host", "uxv"}), 0) << said();
  EXPECT_THAT(said(), HasSubstr("emergency stop ON: the vehicle stands (pressed on its own host"));
  EXPECT_TRUE(stands());
  EXPECT_EQ(own_estop({"status", "--host", "uxv"}), 0) << said();
  EXPECT_THAT(said(), HasSubstr("vehicle stands by emergency stop of: estop ("));
  EXPECT_EQ(own_estop({"off", "--host", "uxv"}), 0) << said();
  EXPECT_TRUE(moves());
}

}  // namespace
}  // namespace tocsin
