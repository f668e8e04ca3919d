// SPDX-License-Identifier: Apache-2.0
// What root launches runs as an ordinary user.
#include <sys/stat.h>
#include <unistd.h>

#include "launch_fixture.hpp"

namespace tocsin::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr uid_t user = 65'533;

const std::string show_rights =
    "grep -E '^(Uid|Gid|Groups|CapPrm|CapEff|NoNewPrivs)' "
    "/proc/self/status | tr -s '\\t' ' '; echo shown; ";

const std::string show_own_rights = "grep CapEff /proc/self/status | tr -s \"\\t\" \" \"\n";

class LaunchAsUser : public LaunchTest {
 protected:
  void SetUp() override {
    if (::geteuid() != 0) GTEST_SKIP() << "only root can become another user";
    ::unsetenv("SUDO_UID");
    ASSERT_EQ(::chmod(folder_.path().c_str(), 0755), 0);
  }
  /// One program on one host that shows its rights and stays.
  [[nodiscard]] static std::string one_program(const std::string& more = "") {
    return "hosts: {a: {role: uxv, address: 127.0.0.1, programs: [{name: p, command: [sh, -c, \"" +
           show_rights + "exec sleep 1000\"]}]}}\n" + more;
  }
  [[nodiscard]] uid_t owner_of(const std::string& name) const {
    struct stat found {};
    EXPECT_EQ(::lstat(folder_.path(name).c_str(), &found), 0) << name;
    return found.st_uid;
  }
  void expect_ordinary(const std::string& process, uid_t who = user) const {
    const std::string rights = folder_.read("run/log/a." + process + ".log");
    const std::string id = std::to_string(who);
    EXPECT_THAT(rights, HasSubstr("Uid: " + id + " " + id + " " + id + " " + id + "\n"));
    EXPECT_THAT(rights, HasSubstr("Gid: " + id + " " + id + " " + id + " " + id + "\n"));
    EXPECT_THAT(rights, HasSubstr("CapPrm: 0000000000000000\nCapEff: 0000000000000000\n"));
    EXPECT_THAT(rights, HasSubstr("NoNewPrivs: 1\n"));
  }
};

TEST_F(LaunchAsUser, EverythingOfTheRunIsOfTheUserThatTheFileNames) {
  launch_file(one_program("user: 65533\n"));
  ASSERT_TRUE(eventually([&] { return printed("[a/p] shown"); })) << output();
  expect_ordinary("p");
  for (const char* path : {"run", "run/deployment.yaml", "run/processes.json", "run/log"}) {
    EXPECT_EQ(owner_of(path), user) << path;
  }
  EXPECT_EQ(owner_of("d.yaml"), 0U);
  EXPECT_THAT(output(), Not(HasSubstr("WARN")));
}

TEST_F(LaunchAsUser, TheOptionTakesThePlaceOfTheFiles) {
  launch_file(one_program("user: 65533\n"), {}, {"--user", "65532"});
  ASSERT_TRUE(eventually([&] { return printed("[a/p] shown"); })) << output();
  expect_ordinary("p", 65'532);
}

TEST_F(LaunchAsUser, WhoCalledSudoIsTheDefault) {
  launch_file(one_program(), {"env", "SUDO_UID=65533"});
  ASSERT_TRUE(eventually([&] { return printed("[a/p] shown"); })) << output();
  expect_ordinary("p");
}

TEST_F(LaunchAsUser, NothingIsLeftWhenTheLauncherIsKilled) {
  launch_file(one_program("user: 65533\n"));
  ASSERT_TRUE(eventually([&] { return printed("[a/p] shown"); })) << output();
  const int process = wait_for_pid("a/p");
  send(SIGKILL);
  EXPECT_TRUE(eventually([&] { return !lives(process); }));
}

TEST_F(LaunchAsUser, WithoutAnybodyItSaysOnceThatItIsRoot) {
  launch_file(one_program(), {}, {});
  ASSERT_TRUE(eventually([&] { return printed("[a/p] shown"); })) << output();
  if (owner_of("run") != 0) GTEST_SKIP() << "this computer has a user tocsin";
  EXPECT_THAT(output(), HasSubstr("WARN: all processes run as root; make a user for them"));
}

TEST_F(LaunchAsUser, AnUnknownUserIsRefusedBeforeAnythingStarts) {
  launch_file(one_program(), {}, {"--user", "no_such_user"});
  EXPECT_EQ(exit_code(), 2);
  EXPECT_THAT(output(), StartsWith("tocsin launch: --user no_such_user: no such user"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path("run")));
}

TEST_F(LaunchAsUser, AUserWhoCannotReadTheFileIsRefused) {
  ASSERT_EQ(::chmod(folder_.path().c_str(), 0700), 0);
  launch_file(one_program(), {}, {"--user", "65533"});
  EXPECT_EQ(exit_code(), 2);
  EXPECT_THAT(output(), HasSubstr("d.yaml: may not be used by this user"));
}

TEST_F(LaunchAsUser, AnEmptyFolderOfRootsIsGivenToTheUser) {
  std::filesystem::create_directory(folder_.path("run"));
  launch_file(one_program("user: 65533\n"));
  ASSERT_TRUE(eventually([&] { return printed("[a/p] shown"); })) << output();
  EXPECT_EQ(owner_of("run"), user);
}

TEST_F(LaunchAsUser, AFolderOfRootsThatALinkNamesIsNot) {
  std::filesystem::create_directory(folder_.path("elsewhere"));
  std::filesystem::create_symlink("elsewhere", folder_.path("run"));
  launch_file(one_program("user: 65533\n"));
  EXPECT_EQ(exit_code(), 2);
  EXPECT_THAT(output(), HasSubstr("symbolic links in it"));
  EXPECT_EQ(owner_of("elsewhere"), 0U);
}

TEST_F(LaunchAsUser, OfAnEmulatedRadioOnlyTheRadioHasRights) {
  if (::access("/dev/net/tun", R_OK | W_OK) != 0) GTEST_SKIP() << "no /dev/net/tun";
  ASSERT_EQ(
      ::chmod(folder_.write_program("bin/link_emulator", show_own_rights + toy_emulator).c_str(),
              0755),
      0);
  folder_.write("c.yaml", "{}");
  const auto host = [](const std::string& name, const std::string& role,
                       const std::string& address) {
    return "  " + name + ": {role: " + role + ", address: " + address +
           ", programs: [{name: p, command: [sh, -c, \"" + show_rights + "exec sleep 1000\"]}]}\n";
  };
  launch_file("user: 65533\nradio: {channel: c.yaml, walls: c.yaml}\nhosts:\n" +
              host("a", "uxv", "10.77.0.1") + host("b", "gcs", "10.77.0.2"));
  ASSERT_TRUE(eventually([&] { return printed("[a/p] shown") && printed("[b/p] shown"); }))
      << output();
  expect_ordinary("p");
  EXPECT_THAT(folder_.read("run/log/radio.log"), HasSubstr("CapEff: 0000000000201000\n"));
  const int first = wait_for_pid("a/p");
  ASSERT_EQ(::kill(first, SIGKILL), 0);
  EXPECT_TRUE(eventually([&] { return pid_of("a/p") != 0 && pid_of("a/p") != first; }))
      << "a process is started again in its network: " << output();
}

}  // namespace
}  // namespace tocsin::cli
