// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "foundation/time.hpp"

namespace tocsin::simulation {

/// What shall happen later, in the order of time; at one instant in the order of asking.
class EventQueue {
 public:
  using Action = std::function<void()>;

  void at(Time time, Action action);
  /// The time of the first event; `never` when there is none.
  [[nodiscard]] Time next() const;
  /// Runs every event due up to and including `now`, also those that are added meanwhile.
  void run(Time now);

 private:
  struct Event {
    Time time;
    std::uint64_t number;
    Action action;
  };
  static bool later(const Event& a, const Event& b);
  std::vector<Event> heap_;
  std::uint64_t asked_ = 0;
};

}  // namespace tocsin::simulation
