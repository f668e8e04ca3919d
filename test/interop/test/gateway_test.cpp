// SPDX-License-Identifier: Apache-2.0
// bringup/gateway.yaml, shipped, between a robot and a station on Cyclone DDS that know nothing of
// it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <set>
#include <string>

#include "cyclone_robot.hpp"
#include "deployment/running_host.hpp"
#include "foundation/temporary_folder.hpp"
#include "stack.hpp"

namespace tocsin::interop {
namespace {

using std::chrono::seconds;

constexpr auto patience = seconds(60);
constexpr std::size_t enough = 10;  // of each topic
/// Domains of gateway.yaml.
constexpr int robot_domain = 0;
constexpr int station_domain = 1;

/// One side, in the network of a process; it is killed in the end.
class CycloneSide {
 public:
  CycloneSide(Side side, int domain, pid_t network, const TemporaryFolder& folder)
      : logs_{folder.path(side == Side::robot ? "robot.sent" : "station.sent"),
              folder.path(side == Side::robot ? "robot.heard" : "station.heard")},
        pid_(fork()) {
    if (pid_ == 0) be(side, domain, network);
  }
  ~CycloneSide() {
    ::kill(pid_, SIGKILL);
    (void)waitpid(pid_, nullptr, 0);
  }
  CycloneSide(const CycloneSide&) = delete;
  CycloneSide& operator=(const CycloneSide&) = delete;

  /// Different samples of a topic, as `HASH BYTES`.
  [[nodiscard]] std::set<std::string> sent(const std::string& topic) const {
    return samples(logs_.sent, topic);
  }
  [[nodiscard]] std::set<std::string> heard(const std::string& topic) const {
    return samples(logs_.heard, topic);
  }

 private:
  [[noreturn]] void be(Side side, int domain, pid_t network) const {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    try {
      deployment::enter_namespaces(network);
      be_cyclone_robot(side, domain, logs_);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "Cyclone DDS: %s\n", error.what());
    }
    _exit(1);
  }
  static std::set<std::string> samples(const std::string& file, const std::string& topic) {
    std::ifstream lines(file);
    std::set<std::string> found;
    for (std::string name, hash, bytes; lines >> name >> hash >> bytes;) {
      if (name == topic) found.insert(hash + " " + bytes);
    }
    return found;
  }
  const RobotLogs logs_;
  const pid_t pid_;
};

/// Whether all that was heard is, byte for byte, what was sent.
bool are_equal(const std::set<std::string>& heard, const std::set<std::string>& sent) {
  return std::includes(sent.begin(), sent.end(), heard.begin(), heard.end());
}

TEST(Gateway, VelocitiesScansAndPicturesOfARobotOnCycloneDdsCrossTheRadioByteForByte) {
  const TemporaryFolder folder;
  const Stack stack(
      {folder.write("gateway_on_one_computer.yaml", gateway_on_one_computer), "--seed", "1"});
  ASSERT_TRUE(Stack::eventually(patience, [&] {
    return stack.logged("gcs is on the link") && stack.logged("uxv is on the link");
  })) << stack.output();
  const CycloneSide robot(Side::robot, robot_domain, stack.pid("uxv/link"), folder);
  const CycloneSide station(Side::station, station_domain, stack.pid("gcs/link"), folder);
  const auto crossed = [&] {
    return robot.heard(velocities).size() >= enough && station.heard(scans).size() >= enough &&
           station.heard(pictures).size() >= enough;
  };
  EXPECT_TRUE(Stack::eventually(patience, crossed))
      << robot.heard(velocities).size() << " velocities, " << station.heard(scans).size()
      << " scans, " << station.heard(pictures).size() << " pictures\n"
      << stack.output();
  for (const char* const topic : {scans, pictures}) {
    const auto heard = station.heard(topic);
    EXPECT_TRUE(Stack::eventually(seconds(5), [&] { return are_equal(heard, robot.sent(topic)); }))
        << topic;
  }
  const auto heard = robot.heard(velocities);
  EXPECT_TRUE(
      Stack::eventually(seconds(5), [&] { return are_equal(heard, station.sent(velocities)); }));
}

}  // namespace
}  // namespace tocsin::interop
