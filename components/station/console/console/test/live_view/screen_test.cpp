// SPDX-License-Identifier: Apache-2.0
#include "live_view/screen.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "view_state.hpp"

namespace tocsin {
namespace {

using terminal::Size;
using ::testing::HasSubstr;
using ::testing::Not;

ViewState with_topics(std::size_t count) {
  ViewState state = full_state();
  state.traffic.clear();
  for (std::size_t i = 0; i < count; ++i) {
    state.traffic.push_back(camera_row());
    state.traffic.back().topic = fmt::format("topic_{:02}", i);
  }
  return state;
}

std::vector<std::string> lines_of(const ViewState& state, Time now = t0, Size size = {110, 40}) {
  return terminal::to_texts(page(state, now, size, limits), size, false);
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string text_of(const ViewState& state, Time now = t0, Size size = {110, 40}) {
  return joined(lines_of(state, now, size));
}

std::string coloured(const ViewState& state, Time now) {
  constexpr Size size{110, 40};
  return joined(terminal::to_texts(page(state, now, size, limits), size, true));
}

TEST(Screen, SaysWhatHasNotBeenHeard) {
  const std::string text = text_of({});
  EXPECT_THAT(text, HasSubstr("no status yet"));
  EXPECT_THAT(text, HasSubstr("no location yet"));
  EXPECT_THAT(text, HasSubstr("no measurement yet"));
  EXPECT_THAT(text, HasSubstr("no decision yet"));
  EXPECT_THAT(text, Not(HasSubstr("Safety")));
  EXPECT_EQ(summary_line({}, t0, limits), "nothing heard yet");
}

/// One page with all that it can tell.
TEST(Screen, TellsSafetyMissionVehicleLinkAndTopicsInThisOrder) {
  ViewState state = routed(full_state());
  state.safety->value.emergency_stop(true);
  state.safety->value.bumper(2);
  const std::string text = text_of(state, t0 + seconds(2), {80, 24});
  EXPECT_THAT(text, ::testing::StartsWith(R"(Tocsin
Safety    EMERGENCY STOP, bumper
Mission   mission_a: running, waypoint 4 of 9, 2:05 min, 4 goals sent
Vehicle   at (1.23, 0.00) m, driving, 4.2 m to go
Link      PER 12.5 %, RTT 0.0 ms, signal -, link quality 0 %, probes 84 kB
Vehicle   PASSIVE by tocp_dsp (cusum_alarm) QNI 50.0, resumes in 24 s
Station   ACTIVE  by tocp_dsp (cusum_alarm) QNI 50.0 [#####.....] 0.0/0.0
Uplink    180 kB/s, backlog 12 ms, loss 3 %, late 3+0, repaired 12+0, scale 0.75
Downlink  180 kB/s, backlog 12 ms, loss 3 %, late 3+0, repaired 12+0, scale 0.75

from the vehicle)"));
  EXPECT_THAT(text, ::testing::EndsWith("0.1 s        95/100  95 % PAUSED\n"));
  EXPECT_THAT(text_of(full_state()), Not(HasSubstr("Safety")));
  EXPECT_THAT(text_of(full_state()), Not(HasSubstr("Uplink"))) << "a host without a router";
}

TEST(Screen, ShowsUnknownValuesAsDash) {
  EXPECT_THAT(text_of(full_state()), HasSubstr("PER 12.5 %, RTT 0.0 ms, signal -,"));
}

TEST(Screen, SaysThatTheDiskIsFullBeforeAllElse) {
  ViewState state = full_state();
  state.disk = {{1}, t0};
  EXPECT_THAT(text_of(state), Not(HasSubstr("Disk")));
  state.disk = {{0.9}, t0};
  EXPECT_EQ(lines_of(state, t0, {80, 5}).front(), "Disk      FULL: recordings and logs are lost");
  EXPECT_THAT(summary_line(state, t0, limits), HasSubstr("disk FULL"));
}

TEST(Screen, NamesTheOtherSiteThatTheVehicleSpeaksWithAsLongAsItIsTold) {
  ViewState state = full_state();
  state.other_site = {{"south"}, t0};
  EXPECT_EQ(lines_of(state, t0, {80, 5}).front(),
            "Site      the vehicle speaks with another one, south");
  EXPECT_THAT(summary_line(state, t0, limits), HasSubstr("speaks with south"));
  EXPECT_THAT(text_of(state, t0 + seconds(12)), Not(HasSubstr("south")));
}

TEST(Screen, AStaleStateOfTheLinkIsGreyAndAnUnknownOneIsNotShown) {
  ViewState state = routed(full_state());
  state.downlink->at = t0 - seconds(12);
  EXPECT_THAT(coloured(state, t0), HasSubstr("Downlink  \x1b[2m180 kB/s"));
  EXPECT_THAT(text_of(state), ::testing::ContainsRegex("Downlink [^\n]*, 12 s ago"));
  state.downlink->at = t0 - seconds(31);
  EXPECT_THAT(text_of(state), HasSubstr("Downlink  unknown for 31 s\n"));
}

TEST(Screen, AStaleValueIsGreyAndSaysItsAge) {
  const std::string text = coloured(full_state(), t0 + seconds(12));
  EXPECT_THAT(text, HasSubstr("\x1b[2mPER 12.5 %\x1b[0m"));
  EXPECT_THAT(text, HasSubstr("\x1b[2mACTIVE \x1b[0m")) << "not green";
  EXPECT_THAT(text, Not(HasSubstr("\x1b[32m")));
  for (const char* label : {"Safety", "Mission", "Vehicle", "Link", "Station"}) {
    EXPECT_THAT(text, ::testing::ContainsRegex(std::string(label) + "[^\n]*, 12 s ago"));
  }
}

TEST(Screen, AfterHalfAMinuteOnlyTheAgeOfAValueIsLeft) {
  const std::string text = text_of(full_state(), t0 + seconds(180));
  for (const char* line : {"Safety    unknown for 3 min\n", "Mission   unknown for 3 min\n",
                           "Vehicle   unknown for 3 min, last seen at (1.23, 0.00) m\n",
                           "Link      unknown for 3 min\n", "Station   unknown for 3 min\n"}) {
    EXPECT_THAT(text, HasSubstr(line));
  }
  EXPECT_THAT(text, Not(HasSubstr("QNI")));
  EXPECT_THAT(text, Not(HasSubstr("ACTIVE")));
}

TEST(Screen, TheVehicleIsAsOldAsTheOlderOfPlaceAndDoing) {
  ViewState state = full_state();
  state.location->at = t0 + seconds(10);
  EXPECT_THAT(text_of(state, t0 + seconds(10)), HasSubstr("m to go, 10 s ago"));
  EXPECT_THAT(text_of(state, t0 + seconds(31)), HasSubstr("at (1.23, 0.00) m, 21 s ago\n"))
      << "what it does is unknown, where it is is not";
}

TEST(Screen, WhatAnOldReportToldIsGreyThenUnknown) {
  ViewState state = full_state();
  state.traffic[0].report_age = seconds(4);
  EXPECT_THAT(coloured(state, t0), HasSubstr("\x1b[2m PAUSED"));
  state.traffic[0].report_age = seconds(31);
  const std::string text = text_of(state);
  EXPECT_THAT(text, HasSubstr("95/- "));
  EXPECT_THAT(text, Not(HasSubstr("PAUSED")));
}

TEST(Screen, ATopicThatIsNotReadHereHasNoShare) {
  ViewState state = full_state();
  state.traffic[0].counting = Counting::not_read;
  EXPECT_THAT(text_of(state), HasSubstr("not read here"));
  EXPECT_THAT(text_of(state), Not(HasSubstr("95 %")));
  state.traffic[0].counting = Counting::no_match;
  EXPECT_THAT(text_of(state), HasSubstr("no writer met"));
  state.traffic[0].counting = Counting::thinned;
  EXPECT_THAT(text_of(state), HasSubstr("thinned"));
}

/// Of every line, and of the page.
void expect_fits(const ViewState& state, Size size) {
  const Size room = terminal::known(size);
  for (const double age_s : {0.0, 12.0, 100.0}) {
    const auto lines = page(state, t0 + seconds(age_s), size, limits);
    EXPECT_LE(lines.size(), room.rows);
    for (const terminal::Line& line : lines) {
      std::string text;
      for (const terminal::Span& span : line) text += span.text;
      EXPECT_LE(terminal::width_of(text), room.columns) << text;
    }
  }
}

TEST(Screen, FitsEveryTerminal) {
  ViewState state = routed(with_topics(20));
  state.safety->value.emergency_stop(true);
  state.mission->value.mission("巡回任務 ümläut");
  state.traffic[3].topic = "地図/画像/圧縮/カメラ/前方/左側/上段";
  for (const Size size : {Size{80, 24}, Size{40, 10}, Size{200, 60}, Size{0, 0}, Size{0, 10},
                          Size{40, 0}, Size{1, 1}, Size{13, 3}, Size{7, 200}, Size{500, 2}}) {
    SCOPED_TRACE(fmt::format("{} x {}", size.columns, size.rows));
    expect_fits(state, size);
  }
}

TEST(Screen, UsesTheWholeHeightAndTellsHowManyTopicsAreMissing) {
  const auto lines = lines_of(with_topics(20), t0, {80, 24});
  ASSERT_EQ(lines.size(), 24U);
  EXPECT_THAT(lines[0], HasSubstr("Mission"));
  EXPECT_THAT(lines[5], HasSubstr("from the vehicle"));
  EXPECT_EQ(lines[23], "and 3 topics more");
  EXPECT_THAT(lines[22], HasSubstr("topic_16"));
}

TEST(Screen, APolicyWithoutAThresholdShowsItsStatisticAlone) {
  ViewState state = full_state();
  state.uxv->value.statistic(42.5);
  state.uxv->value.threshold(-std::numeric_limits<double>::infinity());
  EXPECT_THAT(text_of(state), HasSubstr("] 42.5, resumes in"));
  EXPECT_THAT(text_of(state), Not(HasSubstr("inf")));
  state.uxv->value.threshold(5.5);
  EXPECT_THAT(text_of(state), HasSubstr("] 42.5/5.5, resumes in"));
}

TEST(Screen, KeepsWhatMattersMostInASmallTerminal) {
  const auto lines = lines_of(with_topics(20), t0, {40, 10});
  ASSERT_EQ(lines.size(), 10U);
  EXPECT_EQ(lines[0], "Mission   running, waypoint 4 of 9");
  EXPECT_EQ(lines[1], "Vehicle   at (1.23, 0.00) m, driving");
  EXPECT_EQ(lines[2], "Link      PER 12.5 %, signal -");
  EXPECT_EQ(lines[3], "Vehicle   PASSIVE QNI 50.0");
  EXPECT_THAT(lines[6], HasSubstr("topic_00"));
  EXPECT_THAT(lines[6], HasSubstr("0.1 s"));
  EXPECT_THAT(lines[6], HasSubstr("PAUSED"));
  EXPECT_EQ(lines[9], "and 17 topics more");
}

TEST(Screen, TextOfOthersCannotMoveTheCursor) {
  ViewState state = full_state();
  state.mission->value.mission("\x1b[2J");
  state.traffic[0].topic = "a\nb";
  const std::string text = text_of(state);
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  EXPECT_THAT(text, HasSubstr("\\x1b[2J"));
  EXPECT_THAT(text, HasSubstr("a\\nb"));
  EXPECT_THAT(summary_line(state, t0, limits), Not(HasSubstr("\x1b")));
}

TEST(Screen, ATimeThatIsNoneIsADash) {
  ViewState state = full_state();
  for (const double odd : {1e308, -1.0, std::nan("")}) {
    state.mission->value.elapsed_s(odd);
    EXPECT_THAT(text_of(state), HasSubstr("waypoint 4 of 9, -, 4 goals"));
  }
}

/// 20 topics of which only the last, the camera, carries anything.
ViewState with_idle_topics() {
  ViewState state = full_state();
  state.traffic.assign(20, camera_row());
  for (std::size_t i = 0; i < state.traffic.size(); ++i) {
    TrafficRow& row = state.traffic[i];
    row.topic = fmt::format("topic_{:02}", i);
    row.rate_hz = 0;
    row.paused = false;
    row.sent = row.received = 3;
  }
  state.traffic.back() = camera_row();
  return state;
}

TEST(Screen, WhereThereIsNoRoomTheIdleTopicsGoFirst) {
  const auto lines = lines_of(with_idle_topics(), t0, {80, 24});
  ASSERT_EQ(lines.size(), 24U);
  EXPECT_THAT(lines[6], HasSubstr("camera/image_raw"));
  EXPECT_THAT(lines[7], HasSubstr("topic_00"));
  EXPECT_EQ(lines[23], "and 3 topics more");
}

TEST(Screen, ATopicThatIsPausedOrLosesSamplesIsNotIdle) {
  ViewState state = with_idle_topics();
  state.traffic[17].paused = true;
  state.traffic[18].sent = 4;
  const auto lines = lines_of(state, t0, {80, 24});
  EXPECT_THAT(lines[6], HasSubstr("topic_17"));
  EXPECT_THAT(lines[7], HasSubstr("topic_18"));
}

TEST(SummaryLine, IsOneLine) {
  EXPECT_EQ(summary_line(full_state(), t0, limits),
            "waypoint 4/9 running  at (1.23, 0.00) m  QNI 50.0  vehicle passive (cusum_alarm)  "
            "station active (cusum_alarm)");
}

TEST(SummaryLine, TellsAgesAndWhatHindersTheVehicle) {
  ViewState state = full_state();
  state.safety->value.emergency_stop(true);
  state.location->at = t0 - seconds(40);
  state.uxv->at = t0 - seconds(5);
  EXPECT_EQ(summary_line(state, t0, limits),
            "EMERGENCY STOP  waypoint 4/9 running  location unknown for 40 s  "
            "QNI 50.0  vehicle passive (cusum_alarm) 5 s ago  station active (cusum_alarm)");
}

}  // namespace
}  // namespace tocsin
