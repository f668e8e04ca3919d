// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "metrics/messages.hpp"
#include "metrics/metrics.hpp"
#include "report/summary.hpp"

namespace tocsin::experiment {

/// The part of a run that counts.
struct Window {
  double begin_s;
  double end_s;
  [[nodiscard]] bool holds(double time_s) const { return time_s >= begin_s && time_s < end_s; }
  [[nodiscard]] double length_s() const { return end_s - begin_s; }
};

/// The intervals cut to the window.
[[nodiscard]] std::vector<report::Interval> within(const std::vector<report::Interval>& intervals,
                                                   const Window& window);

/// What was put on the link within a window, by sender and class.
class Traffic {
 public:
  Traffic(const report::Recording& recording, const Window& window);
  /// Empty for a class without samples.
  [[nodiscard]] const std::vector<Message>& of(const report::LinkClass& link_class) const;
  /// All that the vehicle sent, without pictures.
  [[nodiscard]] const std::vector<Message>& telemetry() const { return telemetry_; }

 private:
  std::map<report::LinkClass, std::vector<Message>> classes_;
  std::vector<Message> telemetry_;
};

/// The window in observations of `step_s`; a rest at the end is left out. `poor` is filled by
/// mark_poor().
[[nodiscard]] std::vector<Observation> observe(const report::Recording& recording,
                                               const Traffic& traffic, const Window& window,
                                               double step_s);

/// Fills in which share of each observation lies in the truly poor intervals.
void mark_poor(const std::vector<report::Interval>& poor, const Window& window, double step_s,
               std::vector<Observation>& series);

}  // namespace tocsin::experiment
