// SPDX-License-Identifier: Apache-2.0
#include "command_line/command.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

/// Runs "toy ARGUMENT..." with one option --count and returns its exit code.
int run_toy(std::vector<std::string> arguments, const std::function<int(int)>& body) {
  CLI::App app("A toy", "toy");
  int count = 0;
  app.add_option("--count", count);
  arguments.insert(arguments.begin(), "toy");
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  return run_command(app, static_cast<int>(argv.size()), argv.data(), [&] { return body(count); });
}

TEST(Command, ReturnsWhatTheBodyReturns) {
  EXPECT_EQ(run_toy({"--count", "7"}, [](int count) { return count; }), 7);
}

TEST(Command, BadUsageIsOneLineWithTheNameInFront) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_toy({"--colour"}, [](int) { return 0; }), 2);
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_EQ(text.rfind("toy: ", 0), 0U) << text;
  EXPECT_EQ(text.find('\n'), text.size() - 1) << text;
}

TEST(Command, HelpRunsNothing) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(run_toy({"--help"}, [](int) { return 9; }), 0);
  EXPECT_NE(testing::internal::GetCapturedStdout().find("--count"), std::string::npos);
}

TEST(Command, AConfigErrorIsExitCode2AndAnyOther1) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_toy({}, [](int) -> int { throw ConfigError("wrong"); }), 2);
  EXPECT_EQ(run_toy({}, [](int) -> int { throw std::runtime_error("broken"); }), 1);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "toy: wrong\ntoy: broken\n");
}

}  // namespace
}  // namespace tocsin
