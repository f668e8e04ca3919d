// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <memory>

namespace tocsin {

/// The time of log lines in place of the computer's clock, for a simulation: lines carry it as UTC,
/// and what repeats within a second of it is counted instead of printed.
///
/// Several may exist, each for what one thread logs while it uses it.
class LogClock {
 public:
  using Now = std::function<std::chrono::system_clock::time_point()>;
  explicit LogClock(Now now);
  ~LogClock();
  LogClock(const LogClock&) = delete;
  LogClock& operator=(const LogClock&) = delete;

  /// While it lives, lines that this thread logs carry the clock's time. They may be nested.
  class Use {
   public:
    explicit Use(LogClock& clock);
    ~Use();
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

   private:
    LogClock* before_;
  };

 private:
  friend class Logger;
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tocsin
