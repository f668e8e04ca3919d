// SPDX-License-Identifier: Apache-2.0
#include "deployment/running_host.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

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

TEST(EnterNamespaces, NamesAProcessThatIsNotThere) {
  const pid_t dead = ::fork();
  if (dead == 0) ::_exit(0);
  ::waitpid(dead, nullptr, 0);
  EXPECT_THAT(
      [&] { enter_namespaces(dead); },
      Throws<EnvironmentError>(Property(&EnvironmentError::what, HasSubstr(std::to_string(dead)))));
}

TEST(EnterNamespaces, HasNothingToDoForAProcessOfTheSameNetwork) {
  EXPECT_NO_THROW(enter_namespaces(::getpid()));
}

}  // namespace
}  // namespace tocsin::deployment
