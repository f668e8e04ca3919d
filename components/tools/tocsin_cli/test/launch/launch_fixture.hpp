// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "foundation/temporary_folder.hpp"

namespace tocsin::cli {

/// Stands in for link_emulator: gives each namespace a wlan0 with the address of its --end.
inline const std::string toy_emulator = R"(while [ $# -gt 0 ]; do
  if [ "$1" = --end ]; then
    ns=${2#*:}; address=${ns##*:}; ns=${ns%:*}
    nsenter --net=$ns sh -c "ip link add wlan0 type veth peer name far; ip addr add $address dev wlan0;
      ip link set far up; ip link set wlan0 up" || exit 1
  fi
  shift
done
exec sleep 1000
)";

/// Runs `tocsin-launch` on deployments of toy programs.
class LaunchTest : public ::testing::Test {
 protected:
  LaunchTest() { folder_.write_program("bin/tocsin-check", "exit 0"); }
  ~LaunchTest() override {
    if (pid_ > 0) ::kill(pid_, SIGKILL), ::waitpid(pid_, nullptr, 0);
  }

  /// Starts the launcher on a deployment of one host `a` with these programs (YAML list items).
  void launch(const std::string& programs, const std::string& more = "") {
    launch_file("hosts: {a: {role: uxv, address: 127.0.0.1, programs: [" + programs + "]}}\n" +
                more);
  }
  void launch_file(const std::string& yaml, const std::vector<std::string>& before = {},
                   const std::vector<std::string>& after = {}) {
    std::vector<std::string> more{"--run-dir", folder_.path("run")};
    more.insert(more.end(), after.begin(), after.end());
    launch_without_folder(yaml, before, more);
  }
  void launch_without_folder(const std::string& yaml, const std::vector<std::string>& before,
                             const std::vector<std::string>& after = {}) {
    std::vector<std::string> words = before;
    words.insert(words.end(), {LAUNCH_PROGRAM, folder_.write("d.yaml", yaml)});
    words.insert(words.end(), after.begin(), after.end());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const std::string out = folder_.path("out");
    const std::string search = folder_.path("bin") + ":/usr/sbin:/usr/bin:/sbin:/bin";
    pid_ = ::fork();
    if (pid_ != 0) return;
    ::setenv("PATH", search.c_str(), 1);
    const int file = ::open(out.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    ::dup2(file, STDOUT_FILENO);
    ::dup2(file, STDERR_FILENO);
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
  }

  /// Waits for a condition of the outside world; false when it does not come within 20 s.
  static bool eventually(const std::function<bool()>& condition) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!condition()) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return true;
  }

  [[nodiscard]] std::string output() const { return folder_.read("out"); }
  [[nodiscard]] bool printed(const std::string& text) const {
    return output().find(text) != std::string::npos;
  }

  /// The process id of a running process; 0 when it does not run.
  [[nodiscard]] int pid_of(const std::string& name) const {
    const auto pids = nlohmann::json::parse(folder_.read("run/processes.json"), nullptr, false);
    return pids.is_object() ? pids.value(name, 0) : 0;
  }
  [[nodiscard]] int wait_for_pid(const std::string& name) const {
    EXPECT_TRUE(eventually([&] { return pid_of(name) != 0; })) << name << "\n" << output();
    return pid_of(name);
  }

  void send(int number) const { ::kill(pid_, number); }
  /// The launcher's exit code; -1 when a signal ended it, -2 when it does not end.
  int exit_code() {
    int status = 0;
    if (!eventually([&] { return ::waitpid(pid_, &status, WNOHANG) == pid_; })) return -2;
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  static bool lives(int pid) { return ::kill(pid, 0) == 0; }

  TemporaryFolder folder_;
  pid_t pid_ = -1;
};

}  // namespace tocsin::cli
