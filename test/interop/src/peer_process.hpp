// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <chrono>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace tocsin::interop {

/// One `interop_peer`. It is killed in the end.
class PeerProcess {
 public:
  /// `maker`: cyclone, fast_dds or tocsin. `network`: a process whose network namespace it runs in;
  /// 0: that of the caller.
  PeerProcess(const std::string& maker, int domain, std::string name, pid_t network = 0);
  ~PeerProcess();
  PeerProcess(const PeerProcess&) = delete;
  PeerProcess& operator=(const PeerProcess&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] pid_t pid() const { return pid_; }
  /// Stops it as a debugger does, and lets it go on.
  void freeze() const;
  void thaw() const;
  void kill();
  /// Whether it has heard a sample of `other` that was written after `since`.
  [[nodiscard]] bool has_heard(const PeerProcess& other,
                               std::chrono::steady_clock::time_point since = {}) const;

 private:
  void read_output();
  const std::string name_;
  pid_t pid_ = 0;
  int input_ = -1;
  int output_ = -1;
  mutable std::mutex mutex_;
  std::map<std::string, long long> heard_;  ///< name to the newest instant of writing, in ms
  std::thread thread_;
};

/// Runs a command of the shell; false when it fails.
bool shell(const std::string& command);

/// Another computer: a network namespace with a cable to ours, where the cable is `eth0`,
/// 10.9.0.1/24. Its own end is `eth1`, 10.9.0.2/24.
class OtherComputer {
 public:
  OtherComputer();
  ~OtherComputer();
  OtherComputer(const OtherComputer&) = delete;
  OtherComputer& operator=(const OtherComputer&) = delete;
  /// False when the rights are missing to make it.
  [[nodiscard]] bool is_there() const { return is_there_; }
  /// A process in its namespace.
  [[nodiscard]] pid_t pid() const { return pid_; }

 private:
  pid_t pid_ = 0;
  bool is_there_ = false;
};

}  // namespace tocsin::interop
