// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "report/recording.hpp"

namespace tocsin::report {

/// How a class, or one topic, came through.
struct Traffic {
  std::string name;
  std::uint64_t received = 0;    ///< live
  std::uint64_t backfilled = 0;  ///< later, and not live
  std::uint64_t lost = 0;        ///< sent, but neither came live nor was backfilled
  Spread latency_s{};            ///< from write to reception, live
  Spread age_s{};                ///< of the newest sample at the receiver, over time, live
  double bytes_per_s = 0;        ///< received live
  /// [%] of those sent; NaN when nothing was.
  [[nodiscard]] double lost_percent() const;
};

/// A run in numbers.
struct Summary {
  Mission mission;
  std::string policy;
  int pauses = 0;
  double paused_s = 0;
  double longest_pause_s = 0;
  double length_s = 0;
  Spread per_percent{};
  double qni_median = 0;
  double qni_min = 0;
  double poor_s = 0;             ///< how long the link was poor
  std::vector<Traffic> classes;  ///< each class, the goals, each class while the link was poor
  std::vector<Traffic> topics;
};

[[nodiscard]] Summary summarise(const Recording& recording);

/// Begin and end [s since the Unix epoch].
struct Interval {
  double begin_s;
  double end_s;
};

/// When the vehicle was paused.
[[nodiscard]] std::vector<Interval> pauses_of(const Recording& recording);

/// The link is called poor while the vehicle's QNI is below this.
inline constexpr double poor_below_qni = 60;
[[nodiscard]] std::vector<Interval> poor_intervals(const Recording& recording);

}  // namespace tocsin::report
