// SPDX-License-Identifier: Apache-2.0
#include "command_line/command.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <functional>
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

TEST(Command, RunsTheVerbThatWasSaidAndNeedsOne) {
  std::string said;
  const auto run = [&](std::vector<const char*> words) {
    CLI::App app("A toy", "toy");
    Verbs sut(app);
    sut.add("go", "goes", [&] { return said += "go", 3; })->add_flag("--fast");
    sut.add("stop", "stops", [&] { return said += "stop", 4; });
    words.insert(words.begin(), "toy");
    return sut.run(static_cast<int>(words.size()), const_cast<char**>(words.data()));
  };
  EXPECT_EQ(run({"go", "--fast"}), 3);
  EXPECT_EQ(run({"stop"}), 4);
  EXPECT_EQ(run({}), 2);
  EXPECT_EQ(run({"stop", "--fast"}), 2);
  EXPECT_EQ(said, "gostop");
}

}  // namespace
}  // namespace tocsin
