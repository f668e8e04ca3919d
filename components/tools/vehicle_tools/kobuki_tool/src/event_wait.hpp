// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "foundation/time.hpp"

namespace tocsin::kobuki {

/// Time, and the wait for what a session reacts to: a terminal in real time, or a test's model in
/// virtual time.
class EventWait {
 public:
  virtual ~EventWait() = default;
  [[nodiscard]] virtual Time now() const = 0;
  /// Until bytes wait at the descriptor, if there is one, a key is pressed, or `until`; may return
  /// earlier. The key that was pressed.
  virtual std::optional<char> wait(std::optional<int> descriptor, Time until) = 0;
  /// Whether the user wants it to end.
  [[nodiscard]] virtual bool interrupted() const = 0;
};

}  // namespace tocsin::kobuki
