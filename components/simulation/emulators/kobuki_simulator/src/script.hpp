// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "foundation/time.hpp"

namespace tocsin::kobuki {

/// Faults by the clock: lines of the control channel, each at its time since the start.
///
///     # seconds command
///     2.0 set bumper=2
///     2.5 set bumper=0
///     10 unplug 3
///
/// Pure; `now` must not decrease.
class Script {
 public:
  Script() = default;
  /// Throws ConfigError, naming the line, for a time that is none or goes back, or no command.
  Script(const std::string& text, const std::string& file, Time start);
  /// The next command that is due; call until it is empty.
  [[nodiscard]] std::optional<std::string> due(Time now);
  /// When the next one is due; `never` at the end.
  [[nodiscard]] Time next() const;

 private:
  struct Entry {
    Time at;
    std::string command;
  };
  void add(const std::string& line, const std::string& place, Time start);
  std::vector<Entry> entries_;
  std::size_t done_ = 0;
};

}  // namespace tocsin::kobuki
