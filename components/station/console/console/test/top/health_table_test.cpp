// SPDX-License-Identifier: Apache-2.0
#include "health_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace tocsin::top {
namespace {

using ::testing::HasSubstr;

constexpr Time t0{std::chrono::seconds(100)};
using Values = std::vector<std::pair<std::string, std::string>>;

diagnostic_msgs::msg::DiagnosticArray array(const std::string& name, std::uint8_t level,
                                            const Values& values = {}) {
  diagnostic_msgs::msg::DiagnosticArray message;
  auto& status = message.status().emplace_back();
  status.name(name);
  status.hardware_id("uxv");
  status.level(level);
  status.message("active");
  for (const auto& [key, value] : values) {
    auto& pair = status.values().emplace_back();
    pair.key(key);
    pair.value(value);
  }
  return message;
}

/// The page as text, its lines each with their end.
std::string text_of(const HealthTable& table, std::size_t width, Time now = t0,
                    bool colour = false) {
  std::string text;
  for (const auto& line : page(table.rows(now), table.gone(now), width)) {
    text += terminal::to_text(line, width, colour) + "\n";
  }
  return text;
}

TEST(HealthTable, AFaultThatDoesNotFitBesideTheFiguresHasALineOfItsOwn) {
  HealthTable sut;
  auto other_type = array("drive/odom reader", 2);
  other_type.status().front().message(
      "another end has the type Odometry with another layout (gcs)");
  sut.add(other_type, 7, t0);
  sut.add(array("drive/a", 0), 7, t0);
  const std::string narrow = text_of(sut, 80);
  EXPECT_THAT(narrow,
              HasSubstr("\n      another end has the type Odometry with another layout (gcs)\n"));
  EXPECT_EQ(std::count(narrow.begin(), narrow.end(), '\n'), 4);  // head, fault and its text, fine
  const std::string wide = text_of(sut, 200);
  EXPECT_EQ(std::count(wide.begin(), wide.end(), '\n'), 3);
}

TEST(HealthTable, WhatIsSilentForLongerThanThreeSecondsIsStaleAndAfterThirtyUnknown) {
  HealthTable sut;
  sut.add(array("drive/a", 2), 7, t0);
  EXPECT_EQ(sut.rows(t0 + seconds(3))[0].level, "ERROR");
  const auto stale = sut.rows(t0 + seconds(12.5));
  EXPECT_EQ(stale[0].level, "STALE");
  EXPECT_EQ(stale[0].message, "silent for 12 s");
  EXPECT_EQ(stale[0].age, seconds(12.5));
  EXPECT_EQ(sut.rows(t0 + seconds(3.001))[0].level, "STALE");
  EXPECT_EQ(sut.rows(t0 + seconds(30)).size(), 1U);
  EXPECT_TRUE(sut.rows(t0 + seconds(30.001)).empty());
}

TEST(HealthTable, AStaleRowIsGrey) {
  HealthTable sut;
  sut.add(array("drive/a", 2), 7, t0);
  EXPECT_THAT(text_of(sut, 80, t0, true), HasSubstr("\x1b[31mERROR"));
  EXPECT_THAT(text_of(sut, 80, t0 + seconds(4), true), HasSubstr("\x1b[2mSTALE"));
  EXPECT_THAT(text_of(sut, 80, t0 + seconds(4)), HasSubstr("silent for 4 s"));
}

TEST(HealthTable, AProcessThatIsUnknownIsGoneForTenMinutes) {
  HealthTable sut;
  sut.add(array("drive", 0), 7, t0);
  sut.add(array("drive/a", 0), 7, t0);
  EXPECT_TRUE(sut.gone(t0 + seconds(30)).empty());
  EXPECT_THAT(text_of(sut, 80, t0 + seconds(45)), HasSubstr("STATE\ngone: drive for 45 s\n"));
  EXPECT_EQ(sut.gone(t0 + seconds(600)).size(), 1U);
  EXPECT_TRUE(sut.gone(t0 + seconds(600.1)).empty());
}

TEST(HealthTable, WhatALivingWriterNoLongerReportsHasEnded) {
  HealthTable sut;
  sut.add(array("drive/odom reader", 2), 7, t0);
  sut.add(array("link/odom writer", 2), 8, t0);
  sut.add(array("drive", 0), 7, t0 + seconds(3));
  EXPECT_EQ(sut.rows(t0 + seconds(3)).size(), 3U);
  sut.add(array("drive", 0), 7, t0 + seconds(3.5));
  const auto rows = sut.rows(t0 + seconds(3.5));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].name, "link/odom writer") << "its writer is silent: STALE";
  EXPECT_EQ(rows[1].name, "drive");
}

TEST(HealthTable, SumsUpTheInputs) {
  HealthTable sut;
  sut.add(array("drive/a", 0,
                {{"rate_hz", "50.00"},
                 {"odom.depth", "3"},
                 {"odom.dropped", "2"},
                 {"odom.age_s", "0.1"},
                 {"goal.depth", "1"},
                 {"goal.dropped", "5"},
                 {"goal.age_s", "12.5"}}),
          7, t0);
  const Row row = sut.rows(t0)[0];
  EXPECT_EQ(row.rate_hz, "50.00");
  EXPECT_EQ(row.depth, "3");
  EXPECT_EQ(row.dropped, "7");
  EXPECT_EQ(row.oldest_age, "12.5");
}

TEST(HealthTable, ALevelThatIsNoneIsStale) {
  HealthTable sut;
  sut.add(array("drive/a", 200), 7, t0);
  EXPECT_EQ(sut.rows(t0)[0].level, "STALE");
}

TEST(HealthTable, FitsEveryWidth) {
  HealthTable sut;
  sut.add(array("drive/a_component_with_a_name_that_is_rather_long", 2, {{"rate_hz", "50.00"}}), 7,
          t0);
  sut.add(array("地図/地図", 0), 7, t0);
  for (const std::size_t width : {1U, 8U, 20U, 40U, 80U, 100U, 120U, 200U}) {
    for (const auto& line : page(sut.rows(t0), sut.gone(t0), width)) {
      EXPECT_LE(terminal::width_of(terminal::to_text(line, width, false)), width);
    }
  }
}

TEST(HealthTable, KeepsTheNameAndTheGravestFiguresInANarrowTerminal) {
  HealthTable sut;
  sut.add(array("drive/safety_controller", 0,
                {{"rate_hz", "50.00"}, {"tick_p99_s", "0.000131"}, {"odom.dropped", "2"}}),
          7, t0);
  const std::string text = text_of(sut, 80);
  EXPECT_THAT(text, HasSubstr("OK    drive/safety_controller"));
  EXPECT_THAT(text, HasSubstr("RATE/Hz"));
  EXPECT_THAT(text, HasSubstr("  active\n"));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("DEPTH")));
  EXPECT_THAT(text_of(sut, 200), HasSubstr("DEPTH"));
}

TEST(HealthTable, TextOfOthersCannotMoveTheCursor) {
  HealthTable sut;
  auto odd = array("\x1b[2J", 2);
  odd.status().front().message("\x1b[1;1H \xff");
  sut.add(odd, 7, t0);
  EXPECT_THAT(text_of(sut, 80), ::testing::Not(HasSubstr("\x1b")));
  EXPECT_TRUE(nlohmann::json::accept(to_json(sut.rows(t0))));
}

}  // namespace
}  // namespace tocsin::top
