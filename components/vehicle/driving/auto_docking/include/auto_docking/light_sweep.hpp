// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tocsin {

enum class Turn { left, right };

/// Finds the direction of a light while the base turns on the spot: the middle of the headings at
/// which its middle receiver sees it. So the bearing does not depend on how wide the receiver
/// looks, nor on frames that miss the light. Pure.
class LightSweep {
 public:
  /// The light may be in view from the start: then the base turns back once it has passed, because
  /// half a passage has no middle.
  explicit LightSweep(Turn turn) : turn_(turn) {}
  /// Takes what the receiver sees at a heading; once per frame while the base turns as told by
  /// `turn()`.
  void update(double heading_rad, std::uint8_t signals);

  /// How to turn next.
  [[nodiscard]] Turn turn() const { return turn_; }
  /// Whether the whole light has passed; `bearing_rad` and `signals` tell of it then.
  [[nodiscard]] bool complete() const { return complete_; }
  /// The heading that faces the light, -pi to pi.
  [[nodiscard]] double bearing_rad() const;
  /// All signals seen while it passed.
  [[nodiscard]] std::uint8_t signals() const { return signals_; }

 private:
  void pass();
  Turn turn_;
  bool began_dark_ = false;  ///< so that the passage has a beginning
  bool complete_ = false;
  int dark_for_ = 0;  ///< updates since the light was last seen
  double cos_sum_ = 0;
  double sin_sum_ = 0;
  std::uint8_t signals_ = 0;
};

}  // namespace tocsin
