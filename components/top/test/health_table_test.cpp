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

TEST(HealthTable, PutsTheGravestFirstThenSortsByName) {
  HealthTable sut;
  sut.add(array("drive/b", 0), t0);
  sut.add(array("drive/a", 0), t0);
  sut.add(array("drive/c", 2), t0);
  const auto rows = sut.rows(t0);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].name, "drive/c");
  EXPECT_EQ(rows[0].level, "ERROR");
  EXPECT_EQ(rows[1].name, "drive/a");
}

TEST(HealthTable, AFaultThatDoesNotFitBesideTheFiguresHasALineOfItsOwn) {
  HealthTable sut;
  auto other_type = array("drive/odom reader", 2);
  other_type.status().front().message(
      "another end has the type Odometry with another layout (gcs)");
  sut.add(other_type, t0);
  sut.add(array("drive/a", 0), t0);
  const std::string narrow = to_text(sut.rows(t0), 80);
  EXPECT_THAT(narrow,
              HasSubstr("\n      another end has the type Odometry with another layout (gcs)\n"));
  EXPECT_EQ(std::count(narrow.begin(), narrow.end(), '\n'), 4);  // head, fault and its text, fine
  const std::string wide = to_text(sut.rows(t0), 200);
  EXPECT_EQ(std::count(wide.begin(), wide.end(), '\n'), 3);
}

TEST(HealthTable, WhatIsSilentForLongerThanThreeSecondsIsStaleAndAfterThirtyGone) {
  HealthTable sut;
  sut.add(array("drive/a", 0), t0);
  EXPECT_EQ(sut.rows(t0 + seconds(3))[0].level, "OK");
  EXPECT_EQ(sut.rows(t0 + seconds(3.001))[0].level, "STALE");
  EXPECT_EQ(sut.rows(t0 + seconds(30)).size(), 1U);
  EXPECT_TRUE(sut.rows(t0 + seconds(30.001)).empty());
}

TEST(HealthTable, ANewStatusReplacesTheOld) {
  HealthTable sut;
  sut.add(array("drive/a", 2), t0);
  sut.add(array("drive/a", 0), t0 + seconds(1));
  ASSERT_EQ(sut.rows(t0 + seconds(1)).size(), 1U);
  EXPECT_EQ(sut.rows(t0 + seconds(1))[0].level, "OK");
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
          t0);
  const Row row = sut.rows(t0)[0];
  EXPECT_EQ(row.rate_hz, "50.00");
  EXPECT_EQ(row.depth, "3");
  EXPECT_EQ(row.dropped, "7");
  EXPECT_EQ(row.oldest_age, "12.5");
}

TEST(HealthTable, AnInputThatNeverCameIsOlderThanAll) {
  HealthTable sut;
  sut.add(array("drive/a", 0, {{"odom.age_s", "9"}, {"goal.age_s", "never"}}), t0);
  EXPECT_EQ(sut.rows(t0)[0].oldest_age, "never");
}

TEST(HealthTable, ALevelThatIsNoneIsStale) {
  HealthTable sut;
  sut.add(array("drive/a", 200), t0);
  EXPECT_EQ(sut.rows(t0)[0].level, "STALE");
}

TEST(HealthTable, TheTextIsCutAtTheTerminalsWidth) {
  HealthTable sut;
  sut.add(array("drive/a", 0), t0);
  const std::string text = to_text(sut.rows(t0), 20);
  EXPECT_THAT(text, HasSubstr("drive/a"));
  EXPECT_EQ(text.find('\n'), 20U);
}

TEST(HealthTable, TheJsonHasTheSameRows) {
  HealthTable sut;
  sut.add(array("drive/a", 1), t0);
  const auto json = nlohmann::json::parse(to_json(sut.rows(t0)));
  ASSERT_EQ(json.size(), 1U);
  EXPECT_EQ(json[0]["name"], "drive/a");
  EXPECT_EQ(json[0]["level"], "WARN");
}

}  // namespace
}  // namespace tocsin::top
