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
std::string parsed(std::vector<std::string> words) {
  CLI::App app;
  std::string host = "gcs";
  add_host_option(app, host, "side");
  std::reverse(words.begin(), words.end());  // as CLI11 wants them
  try {
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return host;
}

/// The same of the option that takes a role.
std::string parsed_role(std::vector<std::string> words) {
  CLI::App app;
  std::optional<Role> role;
  add_role_option(app, role, "side");
  std::reverse(words.begin(), words.end());
  try {
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return role ? to_string(*role) : "none";
}

TEST(HostOption, TakesANameWithOrWithoutASlash) {
  EXPECT_EQ(parsed({}), "gcs");
  EXPECT_EQ(parsed({"--host", "uxv"}), "uxv");
  EXPECT_EQ(parsed({"--host", "/uxv"}), "uxv");
}

TEST(RoleOption, TakesUxvAndGcsWithOrWithoutASlashAndNothingElse) {
  EXPECT_EQ(parsed_role({}), "none");
  EXPECT_EQ(parsed_role({"--host", "uxv"}), "uxv");
  EXPECT_EQ(parsed_role({"--host", "/gcs"}), "gcs") << "the slash goes before the check";
  EXPECT_THAT(parsed_role({"--host", "sea"}), HasSubstr("--host: sea not in {uxv,gcs}"));
}

TEST(HostOption, RefusesOtherSpellingsWithAHint) {
  for (const std::string other : {"--on", "--role", "--side"}) {
    EXPECT_EQ(parsed_role({other, "uxv"}), other + ": the side is named by --host uxv");
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
