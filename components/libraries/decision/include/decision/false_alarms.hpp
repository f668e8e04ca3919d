// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "decision/detectors.hpp"

namespace tocsin::decision {

/// Qualities of a good link without end, one after the other. What they have in common with their
/// neighbours is the source's affair: that is why thresholds are tried on it.
class QualitySource {
 public:
  virtual ~QualitySource() = default;
  /// The next quality, in [0,100].
  virtual double next() = 0;
  /// Begins anew, independently of what came before.
  virtual void restart() = 0;
};

/// Independent qualities of a normal law, held within [0,100].
[[nodiscard]] std::unique_ptr<QualitySource> independent(Normal law, std::uint64_t seed);

/// How many paths are simulated, and how far.
struct Effort {
  int paths = 400;
  double horizon = 14400;  ///< [samples] of each path
};

/// The mean number of samples until a detector alarms, for all thresholds at once, simulated: each
/// path keeps the instants at which the statistic exceeds all that it was before. The mean is time
/// at risk over alarms, so that a path without an alarm counts with its horizon.
class FalseAlarmCurve {
 public:
  /// Blocks for effort.paths x effort.horizon samples. `detector` is reset before each path.
  FalseAlarmCurve(QualitySource& source, Detector& detector, const Effort& effort);

  /// [samples]; where no path reaches `threshold`, the time at risk of all of them times two.
  [[nodiscard]] double run_length(double threshold) const;
  /// Paths that reach `threshold`; the relative standard error of run_length is 1/sqrt(this).
  [[nodiscard]] int alarms(double threshold) const;
  /// The threshold with that run length; empty when even the smallest has a longer one.
  [[nodiscard]] std::optional<double> threshold_for(double samples) const;

 private:
  struct Record {
    double level;
    double time;
  };
  using Path = std::vector<Record>;
  [[nodiscard]] static const Record* crossing(const Path& path, double threshold);

  std::vector<Path> paths_;
  double horizon_;
  double highest_ = 0;
};

}  // namespace tocsin::decision
