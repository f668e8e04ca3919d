// SPDX-License-Identifier: Apache-2.0
#include "operator_server/mission_guard.hpp"

#include <gtest/gtest.h>

namespace tocsin::foxglove {
namespace {

const Time t0{seconds(100)};
constexpr const char* mission = "/uxv/follow_waypoints/_action/send_goal";

TEST(MissionGuard, RefusesAMissionOnlyWhileAnotherDrives) {
  MissionGuard sut;
  EXPECT_EQ(sut.refusal(1, mission, t0), "");
  sut.on_driver("anna", t0);
  EXPECT_EQ(sut.refusal(1, mission, t0), "anna drives by hand: ask for control before");
  EXPECT_EQ(sut.refusal(1, "/follow_waypoints/_action/cancel_goal", t0), "") << "who stops may";
  sut.on_operator(1, "ben");
  EXPECT_NE(sut.refusal(1, mission, t0), "");
  sut.on_operator(2, "anna");
  EXPECT_EQ(sut.refusal(2, mission, t0), "");
  sut.forget(2);
  EXPECT_NE(sut.refusal(2, mission, t0), "");
  sut.on_driver("", t0);
  EXPECT_EQ(sut.refusal(1, mission, t0), "");
}

TEST(MissionGuard, AReportThatIsOldDoesNotCount) {
  MissionGuard sut;
  sut.on_driver("anna", t0);
  EXPECT_NE(sut.refusal(1, mission, t0 + std::chrono::milliseconds(2999)), "");
  EXPECT_EQ(sut.refusal(1, mission, t0 + std::chrono::seconds(3)), "");
}

}  // namespace
}  // namespace tocsin::foxglove
