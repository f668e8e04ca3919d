// SPDX-License-Identifier: Apache-2.0
#include "link_state_text/link_state_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace tocsin::link_text {
namespace {

using terminal::Style;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using tocsin_msgs::msg::LinkClass;
using tocsin_msgs::msg::LinkState;

/// 3 and 1 late, 12 and 4 repaired, of class critical and high.
LinkState healthy() {
  LinkState state;
  state.role("uxv");
  state.live_peers(1);
  state.capacity_bytes_per_s(1182400);
  state.capacity_measured(true);
  state.backlog_s(0.0034F);
  state.loss(0.012F);
  state.scale(0.75F);
  state.bytes(1000);
  state.discovery_bytes(20);
  state.acknowledgement_bytes(70);
  state.stop_bytes(110);
  for (const char* name : {"critical", "high", "normal", "low"}) {
    state.classes().emplace_back().traffic_class(name);
  }
  state.classes()[0].offered(100);
  state.classes()[0].late(3);
  state.classes()[0].repaired(12);
  state.classes()[0].repair_bytes(25);
  state.classes()[3].repair_bytes(15);
  state.classes()[1].late(1);
  state.classes()[1].repaired(4);
  state.classes()[3].offered(50);
  state.classes()[3].late(99);
  state.classes()[3].dropped_paused(5);
  state.classes()[3].dropped_expired(2);
  state.classes()[3].unwanted(6);
  state.classes()[3].delay_s(0.0415F);
  return state;
}

std::string text_of(const LinkState& state, std::size_t width = 200) {
  return terminal::to_text(words(state), width, false);
}

std::string table_of(const std::vector<LinkState>& states, std::size_t width = 200) {
  std::string text;
  for (const auto& line : table(states, width))
    text += terminal::to_text(line, width, false) + "\n";
  return text;
}

LinkState with_two_paths() {
  LinkState state = healthy();
  state.paths().resize(2);
  state.paths()[0].chosen(true);
  return state;
}

TEST(LinkStateText, SaysWhichOfTwoPathsIsInUseAndThatTheOtherIsSilent) {
  EXPECT_THAT(text_of(healthy()), Not(HasSubstr("path")));
  LinkState state = with_two_paths();
  EXPECT_THAT(text_of(state), AllOf(HasSubstr(" by the first path,"), Not(HasSubstr("SILENT"))));
  state.paths()[0].chosen(false);
  state.paths()[0].silent(true);
  state.paths()[1].chosen(true);
  EXPECT_THAT(text_of(state), HasSubstr(" by the SECOND path, the other SILENT,"));
}

TEST(LinkStateText, LeavesOutWhatMattersLessWhereThereIsNoRoom) {
  EXPECT_EQ(text_of(healthy()),
            "1182 kB/s, backlog 3 ms, loss 1 %, late 3+1, repaired 12+4, scale 0.75, repairs 4 %, "
            "acknowledgements 7 %, backfill 0 %, stop 11 %, discovery 2 %");
  EXPECT_EQ(text_of(healthy(), 70),
            "1182 kB/s, backlog 3 ms, loss 1 %, late 3+1, repaired 12+4, scale 0.75");
  EXPECT_EQ(text_of(healthy(), 60), "1182 kB/s, backlog 3 ms, loss 1 %, late 3+1, scale 0.75");
  EXPECT_EQ(text_of(healthy(), 30), "1182 kB/s, backlog 3 ms");
}

TEST(LinkStateText, APeerThatDoesNotAnswerStandsBeforeAllElseInRed) {
  LinkState state = healthy();
  state.live_peers(0);
  EXPECT_THAT(text_of(state), StartsWith("no peer, 1182 kB/s"));
  state.silent_peers(1);
  EXPECT_THAT(text_of(state), StartsWith("peer SILENT, 1182 kB/s"));
  EXPECT_EQ(words(state).front().style, Style::bad);
  EXPECT_THAT(text_of(state, 20), StartsWith("peer SILENT")) << "also where there is little room";
  state.live_peers(2);
  EXPECT_THAT(text_of(state), StartsWith("1 SILENT, 1182 kB/s"));
  state.silent_peers(0);
  state.paused(true);
  EXPECT_THAT(text_of(state), StartsWith("PAUSED, 1182 kB/s"));
}

TEST(LinkStateText, ABacklogThatMakesSamplesLateIsAWarning) {
  LinkState state = healthy();
  const auto style = [&state] { return words(state).at(1).style; };
  state.backlog_s(0.25F);
  EXPECT_EQ(style(), Style::plain);
  state.backlog_s(0.251F);
  EXPECT_EQ(style(), Style::warning);
}

TEST(LinkStateText, WhatIsNoNumberIsADash) {
  LinkState state;
  state.live_peers(1);
  state.capacity_bytes_per_s(std::numeric_limits<float>::infinity());
  state.capacity_measured(true);
  state.loss(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(text_of(state),
            "-, backlog 0 ms, loss -, late 0+0, repaired 0+0, scale 0.00, repairs -, "
            "acknowledgements -, backfill -, stop -, discovery -");
}

TEST(LinkStateText, ACapacityThatIsOnlyAssumedIsNotShown) {
  LinkState state = healthy();
  state.capacity_measured(false);
  EXPECT_THAT(text_of(state), StartsWith("capacity not measured, backlog 3 ms"));
  EXPECT_EQ(summary(state), "uplink capacity not measured, loss 1 %");
}

TEST(LinkStateText, ALogGetsTheWayItsCapacityAndLoss) {
  LinkState state = healthy();
  EXPECT_EQ(summary(state), "uplink 1182 kB/s, loss 1 %");
  state.role("gcs");
  state.live_peers(0);
  EXPECT_EQ(summary(state), "downlink no peer, 1182 kB/s, loss 1 %");
}

TEST(LinkStateText, TheTableHasARowForEachClassThatTheHostUses) {
  LinkState down = healthy();
  down.role("gcs");
  const std::string text = table_of({healthy(), down});
  EXPECT_THAT(text, AllOf(HasSubstr("Uplink critical"), HasSubstr("Uplink low"),
                          HasSubstr("Downlink low"), Not(HasSubstr("normal"))));
  EXPECT_THAT(text, ::testing::ContainsRegex("Uplink low +50 .* 99 .* 6 .* 7 +0 +4[12]\n"))
      << "6 unwanted, 7 dropped, for two reasons";
  EXPECT_TRUE(table({}, 80).empty());
}

TEST(LinkStateText, TheTableFitsAndKeepsLateAndLost) {
  for (const std::size_t width : {200U, 80U, 40U, 25U}) {
    for (const auto& line : table({healthy()}, width)) {
      EXPECT_LE(terminal::width_of(terminal::to_text(line, 500, false)), width);
    }
  }
  EXPECT_THAT(table_of({healthy()}, 40), AllOf(HasSubstr("LATE"), HasSubstr("LOST")));
}

TEST(LinkStateText, NamesOfOthersCannotMoveTheCursor) {
  LinkState state = healthy();
  state.classes()[0].traffic_class("\x1b[2J");
  EXPECT_THAT(table_of({state}), AllOf(Not(HasSubstr("\x1b")), HasSubstr("\\x1b[2J")));
}

}  // namespace
}  // namespace tocsin::link_text
