// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <chrono>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace tocsin::interop {

/// How an `interop_peer` is started.
struct PeerOptions {
  std::string maker;  ///< cyclone, fast_dds or tocsin
  int domain = 0;
  std::string name;
  pid_t network = 0;     ///< a process in whose network namespace it runs; 0: that of the caller
  int loss_percent = 0;  ///< [0, 100] of the packets that it sends, and of those that it receives
  int lifespan_ms = 0;   ///< of what it writes; 0: for ever
};

/// One `interop_peer`. It is killed in the end.
class PeerProcess {
 public:
  explicit PeerProcess(PeerOptions options);
  PeerProcess(const std::string& maker, int domain, std::string name, pid_t network = 0)
      : PeerProcess(PeerOptions{maker, domain, std::move(name), network, 0, 0}) {}
  ~PeerProcess();
  PeerProcess(const PeerProcess&) = delete;
  PeerProcess& operator=(const PeerProcess&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] pid_t pid() const { return pid_; }
  /// Stops it as a debugger does, and lets it go on.
  void freeze() const;
  void thaw() const;
  void kill();
  /// Asks it to delete its participant and end.
  void leave();
  /// Whether it has heard a sample of `other` that was written after `since`.
  [[nodiscard]] bool has_heard(const PeerProcess& other,
                               std::chrono::steady_clock::time_point since = {}) const;
  /// How many samples of `other` have come since the last gap. (Who joins may miss one between the
  /// first that he hears and the first heartbeat.)
  [[nodiscard]] std::size_t heard_in_a_row(const PeerProcess& other) const;
  /// The age of the oldest sample of `other` that it was given after `since`.
  [[nodiscard]] std::chrono::milliseconds oldest(const PeerProcess& other,
                                                 std::chrono::steady_clock::time_point since) const;

 private:
  struct Given {
    long long at_ms;
    long long age_ms;
  };
  struct Heard {
    long long newest_ms = 0;  ///< instant of writing
    long long last = 0;       ///< number
    std::size_t in_a_row = 0;
    std::vector<Given> given;
  };
  void read_output();
  const std::string name_;
  pid_t pid_ = 0;
  int input_ = -1;
  int output_ = -1;
  mutable std::mutex mutex_;
  std::map<std::string, Heard> heard_;  ///< by name
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
