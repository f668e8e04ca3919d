// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "runtime/component.hpp"

namespace tocsin::simulation {

/// Ticks components in a fixed order when they have input or a deadline has passed.
class Scheduler {
 public:
  Scheduler() = default;
  Scheduler(const Scheduler&) = delete;  // the components know where their entries are
  Scheduler& operator=(const Scheduler&) = delete;

  /// `running` tells whether the component's process still runs; it ticks for the first time at
  /// `first`.
  void add(Component& component, std::function<bool()> running, Time first = Time::min());
  /// Ticks it no more. Not during a run.
  void remove(const Component& component);
  /// Is told of each component that threw.
  using Failure = std::function<void(const std::string& component, const char* what, Time now)>;
  void set_on_failure(Failure tell) { on_failure_ = std::move(tell); }
  /// The earliest deadline of all; the beginning of time when somebody has input.
  [[nodiscard]] Time next() const { return asked_ ? Time::min() : next_; }
  /// Ticks whoever is due at `now` until all are at rest. A component that throws is ticked no
  /// more. Throws std::runtime_error when one of them never comes to rest.
  void run(Time now);
  [[nodiscard]] std::uint64_t ticks() const { return ticks_; }

 private:
  struct Entry final : Waker {
    Entry(Scheduler& its, Component& one, std::function<bool()> is_running, Time first_tick)
        : scheduler(its), component(one), running(std::move(is_running)), first(first_tick) {}
    void wake() override { scheduler.ask(index); }
    Scheduler& scheduler;
    Component& component;
    std::function<bool()> running;
    Time first;
    std::size_t index = 0;
    bool failed = false;
  };
  void ask(std::size_t index);
  void ask_the_due(Time now);
  void number_entries();
  void run_round(Time now);
  void tick(Entry& entry, Time now);
  [[nodiscard]] const std::string& first_asked() const;

  Failure on_failure_;
  std::vector<std::unique_ptr<Entry>> entries_;
  std::vector<Time> due_;             ///< of each entry
  std::vector<std::uint64_t> words_;  ///< a bit for each entry that has input or a deadline
  bool asked_ = false;                ///< whether a bit may be set
  std::uint64_t ticks_ = 0;
  Time next_ = never;
};

}  // namespace tocsin::simulation
