// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/component.hpp"

namespace tocsin::simulation {

/// Ticks components in a fixed order when they have input or a deadline has passed.
class Scheduler {
 public:
  /// `running` tells whether the component's process still runs; it ticks for the first time at
  /// `first`.
  void add(Component& component, std::function<bool()> running, Time first = Time::min());
  /// Ticks it no more. Not during a run.
  void remove(const Component& component);
  /// Is told of each component that threw.
  using Failure = std::function<void(const std::string& component, const char* what, Time now)>;
  void set_on_failure(Failure tell) { on_failure_ = std::move(tell); }
  /// The earliest deadline of all, as of the last run.
  [[nodiscard]] Time next() const { return next_; }
  /// Ticks whoever is due at `now` until all are at rest. A component that throws is ticked no
  /// more. Throws std::runtime_error when one of them never comes to rest.
  void run(Time now);
  [[nodiscard]] std::uint64_t ticks() const { return ticks_; }

 private:
  struct Entry {
    Component* component;
    Schedule* schedule;
    std::function<bool()> running;
    Time first;
    bool started = false;
    bool failed = false;
  };
  bool run_round(Time now, int round);
  void tick(Entry& entry, Time now);
  Failure on_failure_;
  std::vector<Entry> entries_;
  std::uint64_t ticks_ = 0;
  Time next_ = never;
};

}  // namespace tocsin::simulation
