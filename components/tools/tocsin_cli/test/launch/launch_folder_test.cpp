// SPDX-License-Identifier: Apache-2.0
// The run folder of a launch: nobody else gets it, and nothing that runs depends on it.
#include <fstream>

#include "launch_fixture.hpp"

namespace tocsin::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class LaunchFolderTest : public LaunchTest {
 protected:
  static constexpr const char* sleeper =
      "{name: sleeper, command: [sh, -c, 'echo up; exec sleep 1000']}";

  /// A second launch into the same folder, to its end; its exit code and what it said.
  [[nodiscard]] std::pair<int, std::string> launch_again() const {
    const std::string out = folder_.path("again");
    const std::string command = "PATH=" + folder_.path("bin") + ":$PATH " LAUNCH_PROGRAM " " +
                                folder_.path("d.yaml") + " --run-dir " + folder_.path("run") +
                                " >" + out + " 2>&1";
    const int status = std::system(command.c_str());
    return {WEXITSTATUS(status), folder_.read("again")};
  }
  /// A folder of the run with a disk of its own, which only the launcher and its children see.
  void launch_on_small_disk() {
    fs::create_directory(folder_.path("run"));
    const std::string mount =
        "mount -t tmpfs -o size=3m none " + folder_.path("run") + " && exec \"$@\"";
    launch_file(
        "hosts: {a: {role: uxv, address: 127.0.0.1, programs: [" + std::string(sleeper) + "]}}\n",
        {"unshare", ::getuid() == 0 ? "-m" : "-rm", "sh", "-c", mount, "sh"});
  }
  /// A file of that folder, seen from here.
  [[nodiscard]] std::string on_small_disk(const std::string& name) const {
    return "/proc/" + std::to_string(pid_) + "/root" + folder_.path("run/" + name);
  }
  [[nodiscard]] int pid_on_small_disk() const {
    std::ifstream file(on_small_disk("processes.json"));
    const auto pids = nlohmann::json::parse(file, nullptr, false);
    return pids.is_object() ? pids.value("a/sleeper", 0) : 0;
  }
};

TEST_F(LaunchFolderTest, RefusesAUsedRunFolder) {
  folder_.write("run/notes.txt", "mine");
  launch(sleeper);
  EXPECT_EQ(exit_code(), 2);
  EXPECT_THAT(output(), HasSubstr("--run-dir " + folder_.path("run") + ": is not empty"));
  EXPECT_EQ(folder_.read("run/notes.txt"), "mine");
  EXPECT_FALSE(fs::exists(folder_.path("run/deployment.yaml")));
}

TEST_F(LaunchFolderTest, RefusesTheRunFolderOfARunningLaunch) {
  launch(sleeper);
  const int pid = wait_for_pid("a/sleeper");
  const std::string pids = folder_.read("run/processes.json");
  const std::string deployment = folder_.read("run/deployment.yaml");
  const auto [code, text] = launch_again();
  EXPECT_EQ(code, 2);
  EXPECT_THAT(text, HasSubstr(folder_.path("run") + ": another run is using it"));
  EXPECT_EQ(folder_.read("run/processes.json"), pids);
  EXPECT_EQ(folder_.read("run/deployment.yaml"), deployment);
  EXPECT_TRUE(lives(pid));
}

TEST_F(LaunchFolderTest, RefusesTheRunFolderOfALaunchThatWasKilled) {
  launch(sleeper);
  (void)wait_for_pid("a/sleeper");
  send(SIGKILL);
  EXPECT_EQ(exit_code(), -1);
  EXPECT_THAT(launch_again().second, HasSubstr("is not empty"));
}

TEST_F(LaunchFolderTest, GoesOnWithoutItsRunFolder) {
  launch(sleeper);
  const int pid = wait_for_pid("a/sleeper");
  ASSERT_TRUE(eventually([&] {  // the launcher may write there meanwhile
    std::error_code busy;
    fs::remove_all(folder_.path("run"), busy);
    return !busy;
  }));
  ASSERT_TRUE(eventually([&] { return printed("RUN FOLDER GONE"); })) << output();
  ::kill(pid, SIGKILL);
  EXPECT_TRUE(eventually([&] { return printed("restarting"); }));
  send(SIGINT);
  EXPECT_EQ(exit_code(), 128 + SIGINT) << output();
}

TEST_F(LaunchFolderTest, SaysThatTheDiskIsFullAndKeepsItsListOfProcesses) {
  launch_on_small_disk();
  ASSERT_TRUE(eventually([&] { return pid_on_small_disk() != 0; })) << output();
  const int before = pid_on_small_disk();
  {
    std::ofstream fill(on_small_disk("fill"));
    const std::string block(4096, 'x');
    while (fill << block << std::flush) {
    }
  }
  ASSERT_TRUE(eventually([&] { return printed("DISK FULL"); })) << output();
  ::kill(before, SIGKILL);
  ASSERT_TRUE(eventually([&] { return printed("restarting"); })) << output();
  EXPECT_EQ(pid_on_small_disk(), before);  // the old list, whole
  fs::remove(on_small_disk("fill"));
  ASSERT_TRUE(eventually([&] { return printed("has room again"); })) << output();
  EXPECT_TRUE(eventually([&] { return pid_on_small_disk() != before; }));
  std::ifstream log(on_small_disk("log/launch.log"));
  const std::string lines{std::istreambuf_iterator<char>(log), {}};
  EXPECT_THAT(lines, HasSubstr("has room again"));  // what was full before is written again
}

// As a service at power on: its folder on a full disk, and systemd's folder in memory.
TEST_F(LaunchFolderTest, StartsOnAFullDiskWithAFolderInMemory) {
  fs::create_directories(folder_.path("state"));
  fs::create_directories(folder_.path("memory"));
  const std::string state = folder_.path("state");
  const std::string command =
      "mount -t tmpfs -o size=64k none " + state + " && cd " + state +
      " && { cat /dev/zero >full; RUNTIME_DIRECTORY=" + folder_.path("memory") + " exec \"$@\"; }";
  launch_without_folder(
      "hosts: {a: {role: uxv, address: 127.0.0.1, programs: [" + std::string(sleeper) + "]}}\n",
      {"unshare", ::getuid() == 0 ? "-m" : "-rm", "sh", "-c", command, "sh"});
  ASSERT_TRUE(eventually([&] { return printed("up"); })) << output();
  EXPECT_THAT(output(), HasSubstr("NO DISK: "));
  EXPECT_FALSE(fs::is_empty(folder_.path("memory")));
  send(SIGINT);
  EXPECT_EQ(exit_code(), 128 + SIGINT) << output();
}

TEST_F(LaunchFolderTest, GivesContainersTheirFileInMemory) {
  folder_.write_program("bin/tocsin-container", "rm -r " + folder_.path("run") + "; head -1 $4");
  folder_.write("f.yaml", "{}");
  launch_file(
      "qos: f.yaml\ntraffic: f.yaml\nhosts: {a: {role: uxv, address: 127.0.0.1, "
      "containers: [{name: c, components: [x]}]}}");
  EXPECT_EQ(exit_code(), 0);
  EXPECT_THAT(output(), HasSubstr("[a/c] # Written by tocsin launch"));
}

}  // namespace
}  // namespace tocsin::cli
