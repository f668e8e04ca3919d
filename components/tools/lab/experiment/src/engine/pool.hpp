// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <csignal>
#include <cstddef>
#include <functional>
#include <list>
#include <optional>

#include "foundation/file_descriptor.hpp"

namespace tocsin::experiment {

/// How a job ended.
struct JobEnd {
  std::size_t job;
  int exit_code = 0;  ///< of the body; meaningless after a signal
  int signal = 0;     ///< that killed it; 0: none
};

/// Runs jobs in a few worker processes, one job at a time in each: one that crashes takes its
/// worker with it and no other job; a new worker is made for the next. What a worker has read and
/// computed once stays there for its later jobs. SIGINT and SIGTERM while it lives are noted, not
/// obeyed. One at a time in a process.
class Pool {
 public:
  /// `body` runs in a worker process; what it returns, 0 to 255, is the exit code.
  Pool(int at_a_time, std::function<int(std::size_t job)> body);
  /// Kills what still runs, by its process id.
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  [[nodiscard]] bool has_room() const { return busy() < at_a_time_; }
  [[nodiscard]] bool idle() const { return busy() == 0; }
  /// Throws EnvironmentError when no process can be made.
  void start(std::size_t job);
  /// Waits for the next job to end; none when interrupted or idle.
  [[nodiscard]] std::optional<JobEnd> wait();
  [[nodiscard]] bool interrupted() const;
  /// Ends all jobs and workers and waits for them.
  void stop();

 private:
  struct Worker {
    pid_t process;
    FileDescriptor socket;  ///< jobs go in, exit codes come out
    std::optional<std::size_t> job;
  };
  using Workers = std::list<Worker>;
  [[nodiscard]] std::size_t busy() const;
  Worker& free_worker();
  Worker& make_worker();
  [[noreturn]] void work(int socket);
  [[nodiscard]] Workers::iterator next_ready();
  JobEnd take(Workers::iterator worker);

  std::size_t at_a_time_;
  std::function<int(std::size_t)> body_;
  Workers workers_;
  struct sigaction old_int_ {};
  struct sigaction old_term_ {};
};

}  // namespace tocsin::experiment
