// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "geometry/twist.hpp"

namespace tocsin {

/// One source of velocities.
struct MuxInput {
  std::string name;
  int priority = 0;        ///< greater wins; no two alike
  double timeout_s = 0.5;  ///< [s] silence after which it loses its turn
};

/// Inputs from words like "teleop 30 0.5, navigation 10 0.5": name, priority, timeout [s].
/// Throws ConfigError naming the word that is wrong.
[[nodiscard]] std::vector<MuxInput> parse_inputs(const std::string& text);
[[nodiscard]] std::string to_text(const std::vector<MuxInput>& inputs);

/// Lets one of several sources drive: the one of highest priority that has spoken lately.
///
/// A message of the active source passes unchanged. When the last source falls silent a zero comes
/// out once; the mux of ROS just stops publishing. Nothing passes while the emergency stop is
/// pressed, and what was wanted before is forgotten. Pure; `now` must not decrease.
class VelocityMux {
 public:
  /// Throws ConfigError for no input, equal names or priorities, or a timeout that is not positive.
  explicit VelocityMux(std::vector<MuxInput> inputs) { set_inputs(std::move(inputs)); }
  /// Replaces the list while running. An active source that stays keeps its turn. Throws as the
  /// constructor does, and changes nothing then.
  void set_inputs(std::vector<MuxInput> inputs);

  /// A velocity of the source `name`, as it shall be passed on; empty when another source has its
  /// turn or the name is unknown.
  [[nodiscard]] std::optional<geometry::Twist> on_command(const std::string& name,
                                                          const geometry::Twist& velocity,
                                                          Time now);
  /// Pressing ends the active source's turn: a zero comes out of the next `on_time`.
  void on_emergency_stop(bool pressed);
  /// Zero, once, when the active source has timed out. Call at `next_deadline`.
  [[nodiscard]] std::optional<geometry::Twist> on_time(Time now);
  [[nodiscard]] Time next_deadline() const;
  /// The source whose turn it is; "idle" when none.
  [[nodiscard]] std::string active() const { return active_ ? active_->name : "idle"; }
  [[nodiscard]] const std::vector<MuxInput>& inputs() const { return inputs_; }

 private:
  [[nodiscard]] const MuxInput* find(const std::string& name) const;
  [[nodiscard]] bool expired(Time now) const { return active_ && now >= next_deadline(); }
  std::vector<MuxInput> inputs_;
  std::optional<MuxInput> active_;
  Time last_ = Time::min();
  bool stopped_ = false;  ///< the emergency stop is pressed
};

}  // namespace tocsin
