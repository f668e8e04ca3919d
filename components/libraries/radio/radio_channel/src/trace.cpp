// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/trace.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "foundation/error.hpp"

namespace tocsin::radio {

Trace::Trace(std::vector<TracePoint> points) : points_(std::move(points)) {
  const std::string name = "radio_channel.trace_file: ";
  if (points_.size() < 2 || !(points_.back().time_s > points_.front().time_s)) {
    throw ConfigError(name + "a trace needs two instants");
  }
  const double begin_s = points_.front().time_s;
  double last_s = begin_s;
  for (TracePoint& point : points_) {
    if (!std::isfinite(point.time_s) || !std::isfinite(point.rssi_dbm) || point.time_s < last_s) {
      throw ConfigError(name + "time_s must not decrease, rssi_dbm must be a number (near " +
                        std::to_string(last_s) + " s)");
    }
    last_s = point.time_s;
    point.time_s -= begin_s;
  }
  length_s_ = points_.back().time_s;
  mark_dead();
}

void Trace::mark_dead() {
  dead_.assign(points_.size(), false);
  for (std::size_t from = 0; from < points_.size();) {
    std::size_t until = from;
    while (until < points_.size() && std::isnan(points_[until].delay_s)) ++until;
    const double end_s = until < points_.size() ? points_[until].time_s : length_s_;
    if (until > from && end_s - points_[from].time_s > dead_after_s) {
      std::fill(dead_.begin() + static_cast<std::ptrdiff_t>(from),
                dead_.begin() + static_cast<std::ptrdiff_t>(until), true);
    }
    from = std::max(until, from + 1);
  }
}

double Trace::folded(double t_s) const {
  const double rest_s = std::fmod(t_s, length_s_);
  return rest_s < 0 ? rest_s + length_s_ : rest_s;
}

/// The last point not after `folded_s`.
std::size_t Trace::at(double folded_s) const {
  const auto after = std::upper_bound(points_.begin(), points_.end(), folded_s,
                                      [](double t, const TracePoint& p) { return t < p.time_s; });
  return static_cast<std::size_t>(after - points_.begin()) - 1;
}

double Trace::rssi_dbm(double t_s) const {
  const double now_s = folded(t_s);
  const std::size_t i = at(now_s);
  if (i + 1 >= points_.size()) return points_[i].rssi_dbm;
  const TracePoint& a = points_[i];
  const TracePoint& b = points_[i + 1];
  const double share = (now_s - a.time_s) / (b.time_s - a.time_s);
  return a.rssi_dbm + share * (b.rssi_dbm - a.rssi_dbm);
}

double Trace::one_way_s(double t_s) const {
  const double delay_s = points_[at(folded(t_s))].delay_s;
  return std::isnan(delay_s) ? 0 : delay_s / 2;
}

bool Trace::dead(double t_s) const { return dead_[at(folded(t_s))]; }

}  // namespace tocsin::radio
