// SPDX-License-Identifier: Apache-2.0
#include "live_view/screen.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <sstream>

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

ViewState full_state() {
  ViewState state;
  state.mission.emplace();
  state.mission->mission("mission_a");
  state.mission->state("running");
  state.mission->waypoint(3);
  state.mission->waypoints(9);
  state.mission->elapsed_s(125);
  state.navigation.emplace();
  state.navigation->state("driving");
  state.navigation->distance_m(4.25);
  state.quality.emplace();
  state.quality->per_percent(12.5F);
  state.quality->signal_dbm(std::numeric_limits<float>::quiet_NaN());
  state.uxv.emplace();
  state.uxv->active(false);
  state.uxv->policy("tocp_dsp");
  state.uxv->reason("cusum_alarm");
  state.uxv->qni(50);
  state.uxv->deadline_s(26);
  state.located = true;
  state.x_m = 1.234;
  state.traffic.push_back({"camera/image_raw/compressed", "low", 7.8, 0.12, 95, 100, 11, true});
  return state;
}

TEST(Screen, SaysWhatHasNotBeenHeard) {
  const std::string text = page({}, false);
  EXPECT_THAT(text, HasSubstr("no status yet"));
  EXPECT_THAT(text, HasSubstr("no location yet"));
  EXPECT_THAT(text, HasSubstr("no measurement yet"));
  EXPECT_THAT(text, HasSubstr("no decision yet"));
  EXPECT_EQ(summary_line({}), "nothing heard yet");
}

TEST(Screen, ShowsMissionAndVehicle) {
  const std::string text = page(full_state(), false);
  EXPECT_THAT(text, HasSubstr("mission_a: running, waypoint 4 of 9, 2:05 min"));
  EXPECT_THAT(text, HasSubstr("at (1.23, 0.00) m"));
  EXPECT_THAT(text, HasSubstr("driving, 4.2 m to go"));
}

TEST(Screen, ShowsTheDecisionWithItsRuleAndDeadline) {
  const std::string text = page(full_state(), false);
  EXPECT_THAT(text, HasSubstr("PASSIVE by tocp_dsp (cusum_alarm)"));
  EXPECT_THAT(text, HasSubstr("[#####.....]"));
  EXPECT_THAT(text, HasSubstr("resumes in 26 s"));
}

TEST(Screen, ShowsUnknownValuesAsDash) {
  EXPECT_THAT(page(full_state(), false), HasSubstr("PER 12.5 %, RTT 0.0 ms, signal -,"));
}

TEST(Screen, ShowsDeliveredAndPausedOfATopic) {
  const std::string text = page(full_state(), false);
  EXPECT_THAT(text, HasSubstr("95/100"));
  EXPECT_THAT(text, HasSubstr("95 %"));
  EXPECT_THAT(text, HasSubstr("PAUSED      11"));
}

TEST(Screen, StaysWithinOneHundredColumns) {
  std::istringstream lines(page(full_state(), false));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
}

TEST(Screen, ColoursOnlyWhenAsked) {
  EXPECT_THAT(page(full_state(), false), Not(HasSubstr("\x1b")));
  EXPECT_THAT(page(full_state(), true), HasSubstr("\x1b[31mPASSIVE"));
}

TEST(Screen, SummaryIsOneLine) {
  const std::string line = summary_line(full_state());
  EXPECT_EQ(line, "waypoint 4/9 running  at (1.23, 0.00)  QNI 50.0  vehicle passive (cusum_alarm)");
}

}  // namespace
}  // namespace tocsin
