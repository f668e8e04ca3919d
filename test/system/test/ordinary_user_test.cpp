// SPDX-License-Identifier: Apache-2.0
// A whole launch of an ordinary user without any capability, and others beside it; one of root's
// that becomes an ordinary user.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "foundation/temporary_folder.hpp"
#include "operator_process.hpp"
#include "recorded.hpp"
#include "runtime/testing/kernel.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;
using ::testing::HasSubstr;

constexpr int domain = 216;
constexpr uid_t user = 65'533;
constexpr uid_t other_user = 65'532;

/// As config/tocsin.service starts it.
std::string as(uid_t who) {
  return fmt::format(
      "setpriv --reuid={0} --regid={0} --clear-groups --no-new-privs --bounding-set=-all ", who);
}

class OrdinaryUser : public ::testing::Test {
 protected:
  void SetUp() override {
    if (::geteuid() != 0) GTEST_SKIP() << "only root can become other users";
    if (!kernel_tells_users()) GTEST_SKIP() << "this kernel does not tell whose sockets are";
    ASSERT_EQ(::chown(folder_.path().c_str(), user, user), 0);
    launch_ = std::make_unique<OperatorProcess>(
        std::vector<std::string>{
            "/bin/bash", "-c",
            fmt::format("source {} && exec {} tocsin launch {}/greetings.yaml --domain {} "
                        "--run-dir {}",
                        Stack::setup(), as(user), TOCSIN_REPOSITORY "/components/examples/bringup",
                        domain, folder_.path("run"))},
        log_.path("launch"));
    ASSERT_TRUE(Stack::eventually(seconds(60), [this] {
      return folder_.read("run/log/uxv.listener.log").find("heard") != std::string::npos;
    })) << log_.read("launch");
  }
  /// What `tocsin component list` says to a user.
  [[nodiscard]] static Ended list(uid_t who, const std::string& options) {
    return run_to_end("bash -c 'source " + Stack::setup() + " && " + as(who) +
                          " tocsin component list " + options,
                      "'");
  }
  const TemporaryFolder folder_;
  const TemporaryFolder log_;
  std::unique_ptr<OperatorProcess> launch_;
};

TEST_F(OrdinaryUser, RunsAHostWithoutAnyRightAndOthersDoNotReachIt) {
  const std::string by_domain = fmt::format("--domain {}", domain);
  EXPECT_THAT(list(user, by_domain).output, HasSubstr("/uxv/talker  process"));
  const Ended refused = list(other_user, by_domain);
  EXPECT_EQ(refused.code, 1) << refused.output;
  EXPECT_THAT(refused.output, HasSubstr("no container runs on this host"));
  const Ended root =
      run_to_end(Stack::program("tocsin-component"), "list --run-dir " + folder_.path("run"));
  EXPECT_THAT(root.output, HasSubstr("/uxv/talker  process")) << "root becomes the user of the run";
}

/// `Uid:` of a process, and whether it has any capability.
struct Rights {
  uid_t id = 0;
  bool has_capabilities = true;
};

Rights rights_of(pid_t process) {
  std::ifstream status(fmt::format("/proc/{}/status", process));
  Rights rights;
  for (std::string word; status >> word;) {
    if (word == "Uid:") status >> rights.id;
    if (word == "CapEff:") rights.has_capabilities = (status >> word, word != "0000000000000000");
  }
  return rights;
}

TEST(RootsLaunch, DrivesAMissionAsAnOrdinaryUserWhomRootAsksAndStops) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can become other users";
  const TemporaryFolder folder;
  ASSERT_EQ(::chmod(folder.path().c_str(), 0755), 0);
  const TemporaryFolder log;
  OperatorProcess launch({Stack::program("tocsin"), "launch", "mission.yaml", "--user",
                          std::to_string(user), "--run-dir", folder.path("run")},
                         log.path("launch"));
  const auto drives = [&] {
    const auto states =
        column(recorded_fields(folder.path("run/uxv"), "navigation_status"), "state");
    return std::find(states.begin(), states.end(), "driving") != states.end();
  };
  ASSERT_TRUE(Stack::eventually(seconds(60), drives)) << log.read("launch");
  const auto pids = nlohmann::json::parse(folder.read("run/processes.json"));
  EXPECT_GE(pids.size(), 10U);
  for (const auto& [name, pid] : pids.items()) {
    const Rights rights = rights_of(pid);
    EXPECT_EQ(rights.id, user) << name;
    EXPECT_EQ(rights.has_capabilities, name == "radio") << name;
  }
  const Ended root =
      run_to_end(Stack::program("tocsin-component"), "list --run-dir " + folder.path("run"));
  EXPECT_THAT(root.output, HasSubstr("/navigator  navigator  active")) << "root becomes its user";
  const Ended stop =
      run_to_end(Stack::program("tocsin"), "estop on --run-dir " + folder.path("run"));
  EXPECT_EQ(stop.code, 0) << stop.output;
}

}  // namespace
}  // namespace tocsin
