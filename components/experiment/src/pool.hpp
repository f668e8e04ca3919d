// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <csignal>
#include <cstddef>
#include <functional>
#include <map>
#include <string>

namespace tocsin::experiment {

/// How a job's process ended.
struct JobEnd {
  std::size_t job;
  int exit_code = 0;  ///< of the body; meaningless after a signal
  int signal = 0;     ///< that killed it; 0: none
};

/// Runs jobs in processes of their own, several at a time: one that crashes or leaks harms nobody.
/// SIGINT and SIGTERM while it lives are noted, not obeyed. One at a time in a process.
class Pool {
 public:
  /// `body` runs in the child process; what it returns is the exit code.
  Pool(int at_a_time, std::function<int(std::size_t job)> body);
  /// Kills what still runs, by its process id.
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  [[nodiscard]] bool has_room() const { return running_.size() < at_a_time_; }
  [[nodiscard]] bool idle() const { return running_.empty(); }
  /// Throws EnvironmentError when no process can be made.
  void start(std::size_t job);
  /// Waits for the next job to end; true and `end` filled. False when interrupted or idle.
  [[nodiscard]] bool wait(JobEnd& end);
  [[nodiscard]] bool interrupted() const;
  /// Ends all jobs and waits for them.
  void stop();

 private:
  std::size_t at_a_time_;
  std::function<int(std::size_t)> body_;
  std::map<pid_t, std::size_t> running_;
  struct sigaction old_int_ {};
  struct sigaction old_term_ {};
};

}  // namespace tocsin::experiment
