// SPDX-License-Identifier: Apache-2.0
#include "component/log_lines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/logger.hpp"
#include "runtime/middleware/log_clock.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

class LogLinesTest : public ::testing::Test {
 protected:
  ~LogLinesTest() override {
    for (const char* node : {"", "arm", "gripper"}) log_levels::set(node, LogLevel::unset);
  }
  int noticed_ = 0;
  LogLines sut_{[this] { ++noticed_; }};
  Logger arm_{"left arm", "arm"};
};

TEST_F(LogLinesTest, CarryTheirNodeLevelTimeAndText) {
  const auto before = std::chrono::system_clock::now();
  arm_.warn("joint {} is hot", 3);
  EXPECT_EQ(noticed_, 1);
  const auto line = sut_.take();
  ASSERT_TRUE(line);
  EXPECT_EQ(line->node, "arm");
  EXPECT_EQ(line->level, LogLevel::warn);
  EXPECT_EQ(line->text, "joint 3 is hot");
  EXPECT_GE(line->time, before);
  EXPECT_LE(line->time, std::chrono::system_clock::now());
  EXPECT_FALSE(sut_.take());
}

TEST_F(LogLinesTest, WhenNobodyTakesThemTheOldestMakeRoomAndAreCounted) {
  for (std::size_t i = 0; i < LogLines::capacity + 7; ++i) arm_.info("line {}", i);
  EXPECT_EQ(sut_.take_dropped(), 7U);
  EXPECT_EQ(sut_.take_dropped(), 0U);
  EXPECT_EQ(sut_.take()->text, "line 7");
}

TEST_F(LogLinesTest, WhatIsWrittenByAVirtualClockIsNotAmongThem) {
  LogClock clock([] { return std::chrono::system_clock::time_point(); });
  const LogClock::Use use(clock);
  arm_.info("simulated");
  EXPECT_FALSE(sut_.take());
}

TEST_F(LogLinesTest, ARepetitionIsNotThereEither) {
  arm_.info("again and again");
  arm_.info("again and again");
  EXPECT_TRUE(sut_.take());
  EXPECT_FALSE(sut_.take());
}

TEST_F(LogLinesTest, DebugIsWrittenOnceItsNodeHasThatLevelOnly) {
  arm_.debug("raw {}", 1);
  EXPECT_FALSE(sut_.take());
  log_levels::set("arm", LogLevel::debug);
  ::testing::internal::CaptureStderr();
  arm_.debug("raw {}", 2);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), HasSubstr("debug [left arm] raw 2"));
  EXPECT_EQ(sut_.take()->text, "raw 2");
  Logger("gripper").debug("raw {}", 3);
  EXPECT_FALSE(sut_.take());
}

TEST_F(LogLinesTest, ALevelKeepsBackWhatIsBelowIt) {
  log_levels::set("arm", LogLevel::error);
  ::testing::internal::CaptureStderr();
  arm_.warn("not heard");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_FALSE(sut_.take());
  arm_.error("heard");
  EXPECT_TRUE(sut_.take());
}

TEST_F(LogLinesTest, ANodeWithoutALevelHasThatOfAll) {
  log_levels::set("", LogLevel::error);
  EXPECT_FALSE(log_levels::admit("arm", LogLevel::warn));
  log_levels::set("arm", LogLevel::debug);
  EXPECT_TRUE(log_levels::admit("arm", LogLevel::debug));
  EXPECT_FALSE(log_levels::admit("gripper", LogLevel::warn));
  log_levels::set("arm", LogLevel::unset);
  EXPECT_FALSE(log_levels::admit("arm", LogLevel::warn));
  EXPECT_EQ(log_levels::of("arm"), LogLevel::unset);
  log_levels::set("", LogLevel::unset);
  EXPECT_TRUE(log_levels::admit("arm", LogLevel::info));
  EXPECT_FALSE(log_levels::admit("arm", LogLevel::debug));
}

TEST(LogLevelTest, HasTheNumbersOfRos2AndNoOthers) {
  EXPECT_EQ(to_log_level(0), LogLevel::unset);
  EXPECT_EQ(to_log_level(10), LogLevel::debug);
  EXPECT_EQ(to_log_level(50), LogLevel::fatal);
  EXPECT_FALSE(to_log_level(15));
  EXPECT_FALSE(to_log_level(256 + 10));
}

}  // namespace
}  // namespace tocsin
