// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop_input/hindrances.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Hindrances, NameWhatKeepsTheVehicleTheGravestFirst) {
  tocsin_msgs::msg::SafetyStatus status;
  status.enabled(true);
  EXPECT_THAT(hindrances(status), IsEmpty());
  status.emergency_stop(true);
  status.stopped_by({"station", "anna"});
  status.bumper(2);
  status.cliff(1);
  status.wheel_drop(1);
  status.enabled(false);
  EXPECT_THAT(hindrances(status),
              ElementsAre("EMERGENCY STOP of station and anna", "bumper", "cliff", "wheel drop",
                          "bumper, cliff and wheel drop are not looked at"));
}

}  // namespace
}  // namespace tocsin
