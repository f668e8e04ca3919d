// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace tocsin::radio {

/// What was measured of a real link at one instant.
struct TracePoint {
  double time_s;
  double rssi_dbm;
  double delay_s;  ///< of a probe there and back; NaN: no answer
};

/// A measured link over time, played again and again.
class Trace {
 public:
  /// Times must not decrease and must end after they begin; signals must be finite. Throws
  /// ConfigError otherwise.
  explicit Trace(std::vector<TracePoint> points);

  [[nodiscard]] double length_s() const { return length_s_; }
  /// Signal at `t_s` since the begin, straight between neighbours; any time, also negative.
  [[nodiscard]] double rssi_dbm(double t_s) const;
  /// Half of the measured delay: what one way takes. 0 while nothing answered.
  [[nodiscard]] double one_way_s(double t_s) const;
  /// Whether no probe was answered for `dead_after_s` around `t_s`: nothing came through.
  [[nodiscard]] bool dead(double t_s) const;

 private:
  [[nodiscard]] double folded(double t_s) const;
  [[nodiscard]] std::size_t at(double folded_s) const;
  void mark_dead();

  std::vector<TracePoint> points_;
  std::vector<bool> dead_;
  double length_s_;
};

/// Shorter stretches without an answer are lost probes, longer ones a dead link.
inline constexpr double dead_after_s = 2;

}  // namespace tocsin::radio
