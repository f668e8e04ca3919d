// SPDX-License-Identifier: Apache-2.0
#include "command_line/launch_user.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <map>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A computer with these users, of whom some may not use what they need.
struct Computer {
  std::map<std::string, Account> users{{"root", {"root", 0, 0, "/root"}},
                                       {"bob", {"bob", 1000, 1000, "/home/bob"}},
                                       {"1000", {"bob", 1000, 1000, "/home/bob"}}};
  std::map<uid_t, std::string> denied;

  [[nodiscard]] UserChoice choose(const UserWishes& wishes) const {
    return choose_user(wishes,
                       {[this](const std::string& who) -> std::optional<Account> {
                          const auto found = users.find(who);
                          if (found == users.end()) return std::nullopt;
                          return found->second;
                        },
                        [this](const Account& account) -> std::optional<std::filesystem::path> {
                          const auto found = denied.find(account.id);
                          if (found == denied.end()) return std::nullopt;
                          return found->second;
                        }});
  }
  [[nodiscard]] std::string error_of(const UserWishes& wishes) const {
    try {
      (void)choose(wishes);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  void add_system_user() { users["tocsin"] = {"tocsin", 105, 105, "/nonexistent"}; }
};

TEST(LaunchUser, IsTheOptionsBeforeTheFilesBeforeWhoCalledSudoBeforeTheSystems) {
  Computer sut;
  sut.add_system_user();
  sut.users["eve"] = {"eve", 1001, 1001, "/"};
  EXPECT_EQ(sut.choose({"eve", "bob", "1000"}).account->id, 1001U);
  EXPECT_EQ(sut.choose({"", "eve", "1000"}).account->id, 1001U);
  EXPECT_EQ(sut.choose({"", "", "1000"}).account->id, 1000U);
  EXPECT_EQ(sut.choose({"", "", ""}).account->id, 105U);
}

TEST(LaunchUser, RootCallingSudoIsNobodyElse) {
  Computer sut;
  sut.users["0"] = sut.users["root"];
  sut.add_system_user();
  EXPECT_EQ(sut.choose({"", "", "0"}).account->id, 105U);
}

TEST(LaunchUser, WithoutAnybodyRootStaysAndTheWarningSaysWhatToDo) {
  const UserChoice choice = Computer().choose({});
  EXPECT_FALSE(choice.account);
  EXPECT_THAT(choice.warning, StartsWith("WARN: all processes run as root; make a user"));
}

TEST(LaunchUser, WhoWantsRootGetsRootWithoutAWarning) {
  for (const UserWishes& wishes : {UserWishes{"root", "bob", "1000"}, {"", "root", "1000"}}) {
    const UserChoice choice = Computer().choose(wishes);
    EXPECT_FALSE(choice.account);
    EXPECT_EQ(choice.warning, "");
  }
}

TEST(LaunchUser, AnUnknownOneIsRefused) {
  EXPECT_THAT(Computer().error_of({"bub", "", ""}), StartsWith("--user bub: no such user"));
  EXPECT_THAT(Computer().error_of({"", "bub", ""}), StartsWith("user: bub: no such user"));
}

TEST(LaunchUser, ANamedOneWhoMayNotUseWhatItNeedsIsRefusedWithThePath) {
  Computer sut;
  sut.denied[1000] = "/root/x.yaml";
  EXPECT_EQ(sut.error_of({"bob", "", ""}),
            "--user bob: /root/x.yaml: may not be used by this user");
}

TEST(LaunchUser, OneWhomNobodyNamedIsPassedOverWithAWarning) {
  Computer sut;
  sut.denied[1000] = "/root/x.yaml";
  const UserChoice choice = sut.choose({"", "", "1000"});
  EXPECT_FALSE(choice.account);
  EXPECT_THAT(choice.warning, HasSubstr("bob, who called sudo, may not use /root/x.yaml"));
}

TEST(LaunchUser, OnlyRootBecomesAnotherUser) {
  if (::geteuid() == 0) GTEST_SKIP() << "root does";
  EXPECT_FALSE(choose_user(std::to_string(::geteuid()), "root", {}).account);
  EXPECT_THROW((void)choose_user("root", "", {}), ConfigError);
}

}  // namespace
}  // namespace tocsin
