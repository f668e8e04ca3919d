// SPDX-License-Identifier: Apache-2.0
#include "command_line/host_option.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// What a command line makes of the option, or why it is refused.
std::string parsed(std::vector<std::string> words, bool limited = false) {
  CLI::App app;
  std::string host = "gcs";
  CLI::Option* const option = add_host_option(app, host, "side");
  if (limited) option->check(CLI::IsMember({"uxv", "gcs"}));
  std::reverse(words.begin(), words.end());  // as CLI11 wants them
  try {
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return host;
}

TEST(HostOption, TakesANameWithOrWithoutASlash) {
  EXPECT_EQ(parsed({}), "gcs");
  EXPECT_EQ(parsed({"--host", "uxv"}), "uxv");
  EXPECT_EQ(parsed({"--host", "/uxv"}), "uxv");
  EXPECT_EQ(parsed({"--host", "/uxv"}, true), "uxv") << "the slash goes before the check";
  EXPECT_THAT(parsed({"--host", "sea"}, true), HasSubstr("--host: sea not in {uxv,gcs}"));
}

TEST(HostOption, RefusesOtherSpellingsWithAHint) {
  for (const std::string other : {"--on", "--role", "--side"}) {
    EXPECT_EQ(parsed({other, "uxv"}), other + ": the side is named by --host uxv");
  }
}

TEST(HostOption, TheHelpShowsOneSpelling) {
  CLI::App app;
  std::string host;
  add_host_option(app, host, "side");
  EXPECT_THAT(app.help(), HasSubstr("--host"));
  EXPECT_THAT(app.help(), Not(HasSubstr("--role")));
}

TEST(NameOption, TakesANameWithOrWithoutASlash) {
  for (const char* given : {"fleet/robot_1", "/fleet/robot_1"}) {
    CLI::App app;
    std::string name;
    add_name_option(app, "--namespace", name, "of topics");
    app.parse(std::vector<std::string>{given, "--namespace"});  // reversed, as CLI11 wants them
    EXPECT_EQ(name, "fleet/robot_1");
  }
}

}  // namespace
}  // namespace tocsin
