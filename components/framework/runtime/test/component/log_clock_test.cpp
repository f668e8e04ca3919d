// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/log_clock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <chrono>
#include <string>
#include <thread>

#include "runtime/logger.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A clock that stands at so many milliseconds after midnight UTC.
class LogClockTest : public ::testing::Test {
 protected:
  LogClockTest() { ::setenv("TZ", "Pacific/Chatham", 1); }  // local time would be another
  std::string logged_at(int ms, const std::string& text) {
    ms_ = ms;
    ::testing::internal::CaptureStderr();
    const LogClock::Use use(sut_);
    logger_.info("{}", text);
    return ::testing::internal::GetCapturedStderr();
  }
  int ms_ = 0;
  LogClock sut_{
      [this] { return std::chrono::system_clock::time_point(std::chrono::milliseconds(ms_)); }};
  Logger logger_{"pilot"};
};

TEST_F(LogClockTest, LinesCarryItsTimeAsUtc) {
  EXPECT_THAT(logged_at(3'723'004, "hello"), HasSubstr("01:02:03.004 "));
  EXPECT_THAT(logged_at(3'724'004, "hello"), HasSubstr(" [pilot] hello\n"));
}

TEST_F(LogClockTest, WhatRepeatsWithinItsSecondIsCounted) {
  EXPECT_THAT(logged_at(0, "again"), HasSubstr("again\n"));
  EXPECT_EQ(logged_at(999, "again"), "");
  EXPECT_THAT(logged_at(1000, "again"), HasSubstr("again (1 more since)"));
  EXPECT_THAT(logged_at(2000, "again"), HasSubstr("again\n"));
}

TEST_F(LogClockTest, ALineThatAnotherClockHasSeenIsNew) {
  EXPECT_NE(logged_at(0, "shared"), "");
  LogClock other([] { return std::chrono::system_clock::time_point(); });
  ::testing::internal::CaptureStderr();
  {
    const LogClock::Use use(other);
    logger_.info("shared");
  }
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), HasSubstr("shared\n"));
}

TEST_F(LogClockTest, OtherThreadsAndLaterLinesCarryTheComputersTime) {
  ms_ = 3'723'004;
  ::testing::internal::CaptureStderr();
  {
    const LogClock::Use use(sut_);
    std::thread([this] { logger_.info("from a thread"); }).join();
  }
  logger_.info("later");
  const std::string text = ::testing::internal::GetCapturedStderr();
  EXPECT_THAT(text, HasSubstr("from a thread"));
  EXPECT_THAT(text, HasSubstr("later"));
  EXPECT_THAT(text, Not(HasSubstr("01:02:03.004")));
}

TEST_F(LogClockTest, UsesMayBeNested) {
  LogClock inner([] { return std::chrono::system_clock::time_point(std::chrono::hours(5)); });
  const LogClock::Use outer_use(sut_);
  { const LogClock::Use inner_use(inner); }
  EXPECT_THAT(logged_at(3'723'004, "nested"), HasSubstr("01:02:03.004 "));
}

}  // namespace
}  // namespace tocsin
