// SPDX-License-Identifier: Apache-2.0
// How a trace is to be read, from the command line.
#include "trace_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin::tools {
namespace {

using ::testing::HasSubstr;

TraceOptions parsed(const std::string& line) {
  CLI::App app;
  TraceOptions options;
  declare_trace_options(app, options);
  app.parse(line);
  return options;
}

std::string duration_error(const std::string& text) {
  try {
    (void)parse_duration_s("--false-alarm", text);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(DeclareTraceOptions, TakesColumnRoleAndPeriod) {
  const TraceOptions defaults = parsed("");
  EXPECT_EQ(defaults.column, "");
  EXPECT_EQ(defaults.role, std::nullopt);
  EXPECT_EQ(defaults.period_s, 1);
  const TraceOptions given = parsed("--column rssi --host gcs --period 0.25");
  EXPECT_EQ(given.column, "rssi");
  EXPECT_EQ(given.role, Role::gcs);
  EXPECT_EQ(given.period_s, 0.25);
}

TEST(DeclareTraceOptions, RefusesAPeriodThatIsNoneAndARoleThatIsNone) {
  for (const char* line : {"--period 0", "--period -1", "--period soon", "--period", "--host base",
                           "--host", "--role uxv"}) {
    EXPECT_THROW((void)parsed(line), CLI::ParseError) << line;
  }
}

TEST(ParseDuration, KnowsEachUnit) {
  EXPECT_EQ(parse_duration_s("x", "2min"), 120);
  EXPECT_EQ(parse_duration_s("x", "0.5w"), 302400);
  EXPECT_EQ(parse_duration_s("x", "1e3s"), 1000);
}

TEST(ParseDuration, RefusesWhatIsLongerThanAnyNumber) {
  EXPECT_THAT(duration_error("1e400s"), HasSubstr("'1e400s' is not a duration"));
  EXPECT_THAT(duration_error("1e308w"), HasSubstr("'1e308w' is not a duration"));
  EXPECT_THAT(duration_error("infs"), HasSubstr("is not a duration"));
}

TEST(ParseDuration, NamesTheOptionAndShowsTheTextWithoutControlCharacters) {
  EXPECT_EQ(duration_error("\x1b[2J"),
            "--false-alarm: '\\x1b[2J' is not a duration such as 90s, 5min, 1h, 2d");
  for (const char* bad : {"5MIN", "5 min", "min", "+5s", "0x10s", "5s5", "-0s"}) {
    EXPECT_THAT(duration_error(bad), HasSubstr("--false-alarm: '" + std::string(bad) + "'")) << bad;
  }
}

}  // namespace
}  // namespace tocsin::tools
