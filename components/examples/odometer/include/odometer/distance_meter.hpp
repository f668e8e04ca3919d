// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace example {

/// Adds up how far a vehicle has driven, from the positions that it reports.
///
/// A position counts once it is `step_m` away from the last one that counted, so that the noise of
/// a standing vehicle adds nothing. A jump beyond `jump_m` is no drive (odometry was reset): it
/// adds nothing, and what follows is measured from there.
class DistanceMeter {
 public:
  /// [m], both > 0 and step_m < jump_m.
  DistanceMeter(double step_m, double jump_m) : step_m_(step_m), jump_m_(jump_m) {}
  /// [m] in any fixed frame. One that is not finite is ignored.
  void on_position(double x_m, double y_m);
  /// [m] since construction.
  [[nodiscard]] double driven_m() const { return driven_m_; }

 private:
  struct Position {
    double x_m, y_m;
  };
  double step_m_;
  double jump_m_;
  double driven_m_ = 0;
  std::optional<Position> last_;
};

}  // namespace example
