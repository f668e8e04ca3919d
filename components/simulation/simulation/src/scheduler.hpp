// SPDX-License-Identifier: Apache-2.0
#pragma once

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
  /// Frozen, it is not ticked; thawed, it is ticked at once. Not during a run.
  void freeze(const Component& component, bool frozen);
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
        : scheduler(its),
          component(one),
          running(std::move(is_running)),
          first(first_tick),
          due(first_tick) {}
    void wake() override { scheduler.ask(*this); }
    Scheduler& scheduler;
    Component& component;
    std::function<bool()> running;
    Time first;
    Time due;            ///< when it is ticked without input
    bool asked = false;  ///< has its turn in this round or the next
    bool failed = false;
    bool frozen = false;
  };
  void ask(Entry& entry);
  void ask_the_due(Time now);
  void run_round(Time now);
  void tick(Entry& entry, Time now);
  [[nodiscard]] Time earliest() const;
  [[nodiscard]] const std::string& first_asked() const;

  Failure on_failure_;
  std::vector<std::unique_ptr<Entry>> entries_;  ///< in the order of their turns
  bool asked_ = false;                           ///< whether an entry may be asked
  std::uint64_t ticks_ = 0;
  Time next_ = never;
};

}  // namespace tocsin::simulation
