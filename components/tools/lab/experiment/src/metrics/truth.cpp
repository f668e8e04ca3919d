// SPDX-License-Identifier: Apache-2.0
#include "metrics/truth.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::experiment {
namespace {

using report::Interval;

double mean_or_nan(double sum, int count) { return count > 0 ? sum / count : std::nan(""); }

/// First instant of [from, until) within a pause; nothing: NaN.
double first_silence(const std::vector<Interval>& pauses, double from_s, double until_s) {
  for (const Interval& pause : pauses) {
    if (pause.end_s > from_s && pause.begin_s < until_s) return std::max(pause.begin_s, from_s);
  }
  return std::nan("");
}

/// When the gate is open for the first time from `at_s` on.
double next_open(const std::vector<Interval>& pauses, double at_s) {
  for (const Interval& pause : pauses) {
    if (pause.begin_s <= at_s && pause.end_s > at_s) return pause.end_s;
  }
  return at_s;
}

}  // namespace

std::vector<Interval> truly_poor(const std::vector<report::LinkState>& link, const PoorLink& limits,
                                 double begin_s, double end_s) {
  std::vector<Interval> poor;
  for (std::size_t i = 0; i + 1 < link.size(); ++i) {
    if (!(link[i].mean_snr_db < limits.below_db)) continue;
    const double from_s = std::max(link[i].time_s, begin_s);
    const double until_s = std::min(link[i + 1].time_s, end_s);
    if (until_s <= from_s) continue;
    if (!poor.empty() && from_s - poor.back().end_s < limits.shortest_s) {
      poor.back().end_s = until_s;
    } else {
      poor.push_back({from_s, until_s});
    }
  }
  const auto is_short = [&](const Interval& i) { return i.end_s - i.begin_s < limits.shortest_s; };
  poor.erase(std::remove_if(poor.begin(), poor.end(), is_short), poor.end());
  return poor;
}

double length_s(const std::vector<Interval>& intervals) {
  double sum_s = 0;
  for (const Interval& interval : intervals) sum_s += interval.end_s - interval.begin_s;
  return sum_s;
}

double common_s(const std::vector<Interval>& a, const std::vector<Interval>& b) {
  double sum_s = 0;
  for (const Interval& one : a) {
    for (const Interval& other : b) {
      const double from_s = std::max(one.begin_s, other.begin_s);
      sum_s += std::max(0.0, std::min(one.end_s, other.end_s) - from_s);
    }
  }
  return sum_s;
}

AgainstTruth compare(const std::vector<Interval>& poor, const std::vector<Interval>& pauses,
                     double begin_s, double end_s) {
  AgainstTruth result;
  double detect_s = 0;
  double resume_s = 0;
  int ended = 0;
  for (const Interval& interval : poor) {
    ++result.intervals;
    const double silent_s = first_silence(pauses, interval.begin_s, interval.end_s);
    result.missed += std::isnan(silent_s) ? 1 : 0;
    if (!std::isnan(silent_s)) detect_s += silent_s - interval.begin_s;
    if (interval.end_s >= end_s) continue;
    ++ended;
    resume_s += std::min(next_open(pauses, interval.end_s), end_s) - interval.end_s;
  }
  const double poor_s = length_s(poor);
  const double good_s = end_s - begin_s - poor_s;
  const double silent_poor_s = common_s(poor, pauses);
  result.detect_s = mean_or_nan(detect_s, result.intervals - result.missed);
  result.resume_s = mean_or_nan(resume_s, ended);
  result.sent_in_poor = poor_s > 0 ? 100 * (1 - silent_poor_s / poor_s) : std::nan("");
  result.silent_in_good =
      good_s > 0 ? 100 * (length_s(pauses) - silent_poor_s) / good_s : std::nan("");
  return result;
}

}  // namespace tocsin::experiment
