// SPDX-License-Identifier: Apache-2.0
#include "deployment/running_host.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <memory>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::deployment {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Property;
using ::testing::Throws;

/// A folder as /proc shows processes, with two runs of two hosts.
class RunningHostTest : public ::testing::Test {
 protected:
  static Deployment run(const std::string& run_dir) {
    Deployment deployment;
    deployment.run_dir = run_dir;
    deployment.qos = deployment.traffic = "/etc/none.yaml";
    deployment.hosts.resize(2);
    const auto none = std::make_shared<const YAML::Node>(YAML::NodeType::Map);
    const Container container{"one", false, {{"part", "part", none}}};
    deployment.hosts[0] = {"uxv", Role::uxv, "10.0.0.1", {"10.0.0.2"}, 0, {}, {container}};
    deployment.hosts[1] = {"gcs", Role::gcs, "10.0.0.2", {"10.0.0.1"}, 1, {}, {container}};
    return deployment;
  }
  /// A container process whose file is gone, and that holds a copy in descriptor 5.
  void add(int pid, const std::string& run_dir, const std::string& host) {
    const std::string process = "proc/" + std::to_string(pid);
    command(pid, {"/opt/bin/tocsin-container", run_dir + "/deployment.yaml", host, "one",
                  "/proc/self/fd/5"});
    proc_.write(process + "/fd/5", resolved_text(run(run_dir)));
  }
  void command(int pid, const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) line += word + '\0';
    proc_.write("proc/" + std::to_string(pid) + "/cmdline", line);
  }
  /// A container that says that its file is `named`, a path of this computer.
  void add_naming(int pid, const std::string& named) {
    command(pid, {"tocsin-container", named, "gcs", "one", named});
  }
  [[nodiscard]] RunningHosts seen_by(uid_t user) const {
    return running_hosts(proc_.path("proc"), user);
  }
  /// What the kernel shows as the program of a process.
  void program(int pid, const std::string& path) {
    ASSERT_EQ(::symlink(path.c_str(), proc_.path("proc/" + std::to_string(pid) + "/exe").c_str()),
              0);
  }
  [[nodiscard]] RunningHosts all() const { return running_hosts(proc_.path("proc")); }
  [[nodiscard]] RunningHost one(const std::string& run_dir, const std::string& host) const {
    return running_host(run_dir, host, proc_.path("proc"));
  }

  const TemporaryFolder proc_;
};

TEST_F(RunningHostTest, FindsEachHostOnceWithItsOldestProcessThoughTheRunFolderIsGone) {
  add(31, "/gone/a", "uxv");
  add(9, "/gone/a", "gcs");
  add(20, "/gone/a", "uxv");
  add(100, "/gone/b", "gcs");
  const auto found = all();
  ASSERT_EQ(found.hosts.size(), 3U);
  EXPECT_EQ(found.hosts[0].process, 9);
  EXPECT_EQ(found.hosts[0].host, "gcs");
  EXPECT_EQ(found.hosts[1].process, 20);
  EXPECT_EQ(found.hosts[1].itself().address, "10.0.0.1");
  EXPECT_EQ(found.hosts[2].deployment.run_dir, "/gone/b");
  EXPECT_EQ(found.hosts[2].deployment.file, "/gone/b/deployment.yaml");
  EXPECT_EQ(found.hosts[2].deployment.hosts[1].local_domain, 1);
}

TEST_F(RunningHostTest, ReadsTheFileOfAContainerWithoutCopyFromItsFolder) {
  command(7, {"tocsin-container", "run.yaml", "gcs", "link"});
  proc_.write("proc/7/cwd/run.yaml", resolved_text(run("/r")));
  ASSERT_EQ(all().hosts.size(), 1U);
  EXPECT_EQ(all().hosts[0].process, 7);
}

TEST_F(RunningHostTest, TakesNothingElseForAContainer) {
  command(7, {"vim", "tocsin-container", "gcs", "link"});
  command(8, {"tocsin-container", "--help"});
  command(9, {});
  proc_.write("proc/self/cmdline", "x");
  proc_.write("proc/uptime", "1");
  EXPECT_THAT(all().hosts, IsEmpty());
  EXPECT_THAT(all().hidden, IsEmpty());
}

TEST_F(RunningHostTest, TellsOfContainersIntoWhichItCannotLook) {
  command(7, {"tocsin-container", "/r/deployment.yaml", "gcs", "link", "/proc/self/fd/5"});
  EXPECT_THAT(all().hosts, IsEmpty());
  EXPECT_THAT(all().hidden, ElementsAre(7));
  EXPECT_THAT([&] { (void)one("/r", "gcs"); },
              Throws<EnvironmentError>(
                  Property(&EnvironmentError::what, HasSubstr("that this user may look into"))));
}

TEST_F(RunningHostTest, ChoosesByFolderAndName) {
  add(3, "/gone/a", "uxv");
  add(4, "/gone/a", "gcs");
  add(5, "/gone/b", "gcs");
  EXPECT_EQ(one("/gone/b", "gcs").process, 5);
  EXPECT_EQ(one("/gone/./a", "gcs").process, 4);
  EXPECT_EQ(one("/gone/a", "").process, 3);
}

TEST_F(RunningHostTest, NamesTheHostThatDoesNotRunAndTheOneThatIsUnknown) {
  add(5, "/gone/b", "gcs");
  EXPECT_THAT([&] { (void)one("/gone/b", "uxv"); },
              Throws<EnvironmentError>(Property(&EnvironmentError::what,
                                                HasSubstr("nothing runs on host uxv of /gone/b"))));
  EXPECT_THAT([&] { (void)one("/gone/b", "moon"); },
              Throws<ConfigError>(Property(&ConfigError::what, HasSubstr("moon: no such host"))));
  EXPECT_THAT([&] { (void)one("/gone/c", "gcs"); },
              Throws<EnvironmentError>(
                  Property(&EnvironmentError::what, HasSubstr("nothing runs on /gone/c"))));
}

TEST_F(RunningHostTest, AFifoAFolderAndADeviceAreNotOpened) {
  const std::string fifo = proc_.path("fifo");
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  add_naming(7, fifo);
  add_naming(8, proc_.path("proc"));
  add_naming(9, "/dev/zero");
  add(10, "/gone/a", "gcs");
  const auto found = all();  // a writer would be waited for here
  ASSERT_EQ(found.hosts.size(), 1U);
  EXPECT_EQ(found.hosts[0].process, 10);
  EXPECT_THAT(found.hidden, ElementsAre(7, 8, 9));
}

TEST_F(RunningHostTest, OfAHugeFileNoMoreIsReadThanARunCanNeed) {
  const std::string huge = proc_.write("huge", "run_dir: /r\n");
  ASSERT_EQ(::truncate(huge.c_str(), off_t{1} << 40), 0);
  add_naming(7, huge);
  EXPECT_THAT(all().hosts, IsEmpty());
  EXPECT_THAT(all().hidden, ElementsAre(7));
}

TEST_F(RunningHostTest, ALongCommandLineIsReadInPartOnly) {
  command(7, {"tocsin-container", std::string(1U << 20U, 'x'), "gcs", "one"});
  EXPECT_THAT(all().hosts, IsEmpty());
}

TEST_F(RunningHostTest, ProcessesOfOthersAreNotLookedInto) {
  add(7, "/gone/a", "gcs");
  const uid_t another = ::geteuid() + 1;
  EXPECT_THAT(seen_by(another).hosts, IsEmpty());
  EXPECT_THAT(seen_by(another).hidden, ElementsAre(7));
  EXPECT_EQ(seen_by(::geteuid()).hosts.size(), 1U);
}

/// Needs root, who alone can give a file away.
TEST_F(RunningHostTest, RootFindsTheContainersOfOthersByTheirProgramOnly) {
  if (::geteuid() != 0) GTEST_SKIP() << "not root";
  const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  add(7, "/gone/a", "gcs");
  program(7, own / "tocsin-container");
  add(8, "/gone/b", "gcs");
  program(8, "/home/mallory/tocsin-container");
  add(9, "/gone/c", "gcs");  // shows none
  add(10, "/gone/d", "gcs");
  program(10, own / "tocsin-container (deleted)");
  add(11, "/gone/e", "gcs");
  program(11, own / "running_host_test");
  for (const char* const pid : {"7", "8", "9", "10", "11"}) {
    ASSERT_EQ(::chown(proc_.path("proc/" + std::string(pid)).c_str(), 12345, 12345), 0);
  }
  const auto found = seen_by(0);
  ASSERT_EQ(found.hosts.size(), 2U);
  EXPECT_EQ(found.hosts[0].process, 7);
  EXPECT_EQ(found.hosts[1].process, 10);
  EXPECT_THAT(found.hidden, ElementsAre(8, 9, 11));
}

}  // namespace
}  // namespace tocsin::deployment
