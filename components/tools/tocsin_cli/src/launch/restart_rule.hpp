// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>

#include "deployment/deployment.hpp"
#include "foundation/time.hpp"

namespace tocsin::cli {

/// How a process ended: by exit(code), or by a signal.
struct Ending {
  bool by_signal = false;
  int code = 0;  ///< exit code, or signal number
};

/// What is to be done when a process has ended.
struct RestartDecision {
  enum class Kind {
    finished,   ///< it did its work; leave it
    restart,    ///< start it again after `delay`
    refused,    ///< it cannot run as configured; stop everything with `exit_code`
    too_often,  ///< it died again and again; stop everything with `exit_code`
  };
  Kind kind;
  Duration delay{};   ///< of restart
  int exit_code = 0;  ///< of refused and too_often
};

/// Decides whether one process is started again. Pure: `now` must not decrease between calls.
///
/// The wait is backoff_s times two to the power of the restarts within the last 60 s, at most
/// max_backoff_s; a process that was once up for 5 s, and had no restart within the last 60 s, is
/// not waited for. After `limit` restarts within 60 s a process that ends itself is given up; one
/// that was once up for 5 s and is ended from outside, by a signal or by its watchdog (exit code
/// 75), never is: what else runs on this side, and keeps the vehicle safe, must not end with it.
/// A limit of 0 forbids every restart. A process that exits with 1, 2 or 127 (not found) before it
/// was once up for 5 s is not started again.
class RestartRule {
 public:
  explicit RestartRule(const deployment::RestartPolicy& policy) : policy_(policy) {}
  void on_start(Time now) { started_ = now; }
  [[nodiscard]] RestartDecision on_exit(const Ending& ending, Time now);

 private:
  deployment::RestartPolicy policy_;
  Time started_{};
  bool was_up_ = false;
  std::deque<Time> restarts_;
};

}  // namespace tocsin::cli
