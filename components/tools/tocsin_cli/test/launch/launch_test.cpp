// SPDX-License-Identifier: Apache-2.0
#include "launch_fixture.hpp"

namespace tocsin::cli {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string sleeper = "{name: sleeper, command: [sleep, '1000']}";

std::string shell(const std::string& name, const std::string& script) {
  return "{name: " + name + ", command: [sh, -c, \"" + script + "\"]}";
}

/// Two processes: `s` sleeps; `x` runs `script` once `s` is there.
class LaunchPairTest : public LaunchTest {
 protected:
  void launch_pair(const std::string& script, const std::string& more = "") {
    const std::string log = folder_.path("run/log/a.s.log");
    launch(shell("s", "echo $$; exec sleep 1000") + ", " +
               shell("x", "until [ -s " + log + " ]; do sleep 0.01; done; " + script),
           more);
  }
  [[nodiscard]] bool sleeper_lives() const {
    return lives(std::stoi(folder_.read("run/log/a.s.log")));
  }
};

TEST_F(LaunchTest, EndsWhenAllProcessesHaveEndedWell) {
  launch(shell("x", "echo hello"));
  EXPECT_EQ(exit_code(), 0);
  EXPECT_THAT(output(), HasSubstr("[a/x] hello\n"));
}

TEST_F(LaunchTest, PrintsAndLogsWhatAProcessSaysWithoutControlCharacters) {
  launch(R"({name: p, command: [sh, -c, 'printf "\033[2J\007one\ttwo\377\n"']})");
  EXPECT_EQ(exit_code(), 0);
  EXPECT_THAT(output(), HasSubstr("[a/p] \\x1b[2J\\x07one\ttwo\\xff\n"));
  EXPECT_EQ(folder_.read("run/log/a.p.log"), "\\x1b[2J\\x07one\ttwo\\xff\n");
}

TEST_F(LaunchTest, RestartsAProcessThatWasKilled) {
  launch(sleeper);
  const int first = wait_for_pid("a/sleeper");
  ::kill(first, SIGKILL);
  EXPECT_TRUE(eventually([&] { return pid_of("a/sleeper") != 0 && pid_of("a/sleeper") != first; }));
  EXPECT_THAT(output(), HasSubstr("a/sleeper ended with signal 9 (Killed), restarting"));
}

TEST_F(LaunchTest, GivesUpOnAProcessThatDiesAgainAndAgain) {
  launch(shell("x", "echo broken; exit 3") + ", " + sleeper,
         "restart: {backoff_s: 0.01, max_backoff_s: 0.01, limit: 3}");
  EXPECT_EQ(exit_code(), 1);
  EXPECT_THAT(output(), HasSubstr("a/x ended with exit code 3 too often, stopping: broken"));
  EXPECT_EQ(folder_.read("run/log/a.x.log"), "broken\nbroken\nbroken\nbroken\n");
}

TEST_F(LaunchPairTest, StopsEverythingOnAConfigurationError) {
  launch_pair("echo x.speed: 9 is outside; exit 2");
  EXPECT_EQ(exit_code(), 2);
  EXPECT_FALSE(sleeper_lives());
  EXPECT_THAT(output(), HasSubstr("a/x ended with exit code 2, stopping: x.speed: 9 is outside"));
}

TEST_F(LaunchPairTest, StopsEverythingWhenAProcessCannotRunHere) {
  launch_pair("exit 1");
  EXPECT_EQ(exit_code(), 1);
  EXPECT_FALSE(sleeper_lives());
}

TEST_F(LaunchPairTest, EndsWithTheProcessThatTheFileNames) {
  launch_pair("exit 0", "stop_when_exits: a/x");
  EXPECT_EQ(exit_code(), 0);
  EXPECT_FALSE(sleeper_lives());
  EXPECT_THAT(output(), HasSubstr("a/x ended with exit code 0, stopping"));
}

TEST_F(LaunchPairTest, EndsWithOneWhenTheNamedProcessGivesUp) {
  launch_pair("sleep 5.1; echo mission aborted; exit 1", "stop_when_exits: a/x");
  EXPECT_EQ(exit_code(), 1);
  EXPECT_THAT(output(), HasSubstr("a/x ended with exit code 1, stopping: mission aborted"));
}

TEST_F(LaunchTest, StopsInReverseOrderOnCtrlC) {
  const std::string script =
      "trap 'echo stopped; exit 0' TERM; echo ready; while :; do sleep 0.01; done";
  launch(shell("one", script) + ", " + shell("two", script));
  ASSERT_TRUE(eventually([&] { return printed("[a/one] ready") && printed("[a/two] ready"); }));
  send(SIGINT);
  EXPECT_EQ(exit_code(), 128 + SIGINT);
  EXPECT_LT(output().find("[a/two] stopped"), output().find("[a/one] stopped"));
  EXPECT_THAT(output(), HasSubstr("[a/one] stopped"));
  EXPECT_EQ(folder_.read("run/processes.json"), "{}\n");
}

TEST_F(LaunchTest, KillsWhatDoesNotStopWithinThreeSeconds) {
  launch(shell("deaf", "trap '' TERM; echo ready; while :; do sleep 0.01; done"));
  ASSERT_TRUE(eventually([&] { return printed("ready"); }));
  const int pid = wait_for_pid("a/deaf");
  send(SIGTERM);
  EXPECT_EQ(exit_code(), 128 + SIGTERM);
  EXPECT_FALSE(lives(pid));
  EXPECT_THAT(output(), HasSubstr("a/deaf did not stop within 3 s, killed"));
}

TEST_F(LaunchTest, KillsAtOnceOnTheSecondCtrlC) {
  launch(shell("deaf", "trap '' TERM; echo ready; while :; do sleep 0.01; done"));
  ASSERT_TRUE(eventually([&] { return printed("ready"); }));
  send(SIGINT);
  ASSERT_TRUE(eventually([&] { return printed("Ctrl-C"); }));
  send(SIGINT);
  EXPECT_EQ(exit_code(), 128 + SIGINT);
  EXPECT_THAT(output(), Not(HasSubstr("did not stop")));
}

TEST_F(LaunchTest, LeavesNoProcessWhenItIsKilledItself) {
  launch(sleeper);
  const int pid = wait_for_pid("a/sleeper");
  send(SIGKILL);
  EXPECT_EQ(exit_code(), -1);
  EXPECT_TRUE(eventually([&] { return !lives(pid); }));
}

TEST_F(LaunchTest, LeavesNoGrandchildren) {
  launch(shell("x", "sleep 1000 & echo $!; wait"));
  ASSERT_TRUE(eventually([&] { return !folder_.read("run/log/a.x.log").empty(); }));
  const int grandchild = std::stoi(folder_.read("run/log/a.x.log"));
  send(SIGINT);
  EXPECT_EQ(exit_code(), 128 + SIGINT);
  EXPECT_TRUE(eventually([&] { return !lives(grandchild); }));
}

TEST_F(LaunchTest, RemovesSocketsThatKilledProcessesLeft) {
  launch(shell("x", "python3 -c 'import socket; socket.socket(socket.AF_UNIX).bind(\\\"" +
                        folder_.path("run/left.sock") + "\\\")'"));
  EXPECT_EQ(exit_code(), 0);
  EXPECT_FALSE(std::filesystem::exists(folder_.path("run/left.sock")));
  EXPECT_TRUE(std::filesystem::exists(folder_.path("run/deployment.yaml")));
}

TEST_F(LaunchTest, StartsContainersWithTheResolvedFile) {
  folder_.write_program("bin/tocsin-container", "echo \"$@\"");
  folder_.write("f.yaml", "{}");
  launch_file(
      "qos: f.yaml\ntraffic: f.yaml\nhosts: {a: {role: uxv, address: 127.0.0.1, "
      "containers: [{name: c, components: [x]}]}}");
  EXPECT_EQ(exit_code(), 0);
  EXPECT_THAT(output(), HasSubstr("[a/c] " + folder_.path("run/deployment.yaml") + " a c"));
}

TEST_F(LaunchTest, StartsNothingThatTheCheckRefuses) {
  folder_.write_program("bin/tocsin-check", "echo \"error: $*\"; exit 2");
  folder_.write("bin/tocsin-container", "");
  launch_file(
      "qos: d.yaml\ntraffic: d.yaml\n"
      "hosts: {a: {role: uxv, address: 127.0.0.1, containers: [{name: c, components: [x]}]}}\n");
  EXPECT_EQ(exit_code(), 2);
  EXPECT_EQ(output(), "error: --quiet " + folder_.path("d.yaml") + " --seed 1\n");
  EXPECT_FALSE(std::filesystem::exists(folder_.path("run")));
}

TEST_F(LaunchTest, GivesTheTerminalToOneContainer) {
  folder_.write_program("bin/tocsin-container", "echo $3 speaks");
  folder_.write("f.yaml", "{}");
  launch_file(
      "qos: f.yaml\ntraffic: f.yaml\nhosts: {a: {role: uxv, address: 127.0.0.1, containers: ["
      "{name: c, components: [x]}, {name: t, terminal: true, components: [y]}]}}");
  EXPECT_EQ(exit_code(), 0);
  EXPECT_THAT(output(), EndsWith("t speaks\n"));
  EXPECT_THAT(output(), Not(HasSubstr("c speaks")));
  EXPECT_EQ(folder_.read("run/log/a.c.log"), "c speaks\n");
}

TEST_F(LaunchTest, RejectsAWrongFileBeforeAnythingStarts) {
  launch("{name: x, comand: [true]}");
  EXPECT_EQ(exit_code(), 2);
  EXPECT_THAT(output(), HasSubstr("tocsin launch: hosts.a.programs."));
  EXPECT_FALSE(std::filesystem::exists(folder_.path("run")));
}

TEST_F(LaunchTest, RejectsAProgramThatDoesNotExist) {
  launch("{name: x, command: [no_such_program]}");
  EXPECT_EQ(exit_code(), 2);
  EXPECT_THAT(output(), HasSubstr("a/x: program 'no_such_program' is not found"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path("run")));
}

}  // namespace
}  // namespace tocsin::cli
