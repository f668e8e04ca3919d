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
  /// `running` tells whether the component's process still runs.
  void add(Component& component, std::function<bool()> running);
  /// Is told of each component that threw.
  using Failure = std::function<void(const std::string& component, const char* what, Time now)>;
  void set_on_failure(Failure tell) { on_failure_ = std::move(tell); }
  /// The earliest deadline of all.
  [[nodiscard]] Time next() const;
  /// Ticks whoever is due at `now` until all are at rest. A component that throws is ticked no
  /// more. Throws std::runtime_error when one of them never comes to rest.
  void run(Time now);
  [[nodiscard]] std::uint64_t ticks() const { return ticks_; }

 private:
  struct Entry {
    Component* component;
    std::function<bool()> running;
    bool started = false;
    bool failed = false;
  };
  [[nodiscard]] static bool due(Entry& entry, Time now);
  void tick(Entry& entry, Time now);
  Failure on_failure_;
  std::vector<Entry> entries_;
  std::uint64_t ticks_ = 0;
};

}  // namespace tocsin::simulation
