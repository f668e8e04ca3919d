// SPDX-License-Identifier: Apache-2.0
#include "decision/detectors.hpp"

#include <sstream>

#include "foundation/error.hpp"

namespace tocsin::decision {

double ShiryaevRoberts::add(double l) {
  if (std::isnan(l)) return log_r_;
  cusum_.add(l);
  // ln(1 + R) without overflow for large and without loss for small R
  const double log_1_plus_r =
      log_r_ > 0 ? log_r_ + std::log1p(std::exp(-log_r_)) : std::log1p(std::exp(log_r_));
  log_r_ = l + log_1_plus_r;
  return log_r_;
}

Focus::Focus(Normal good) : good_(good) {
  hull_[0] = {0, 0};
  if (good.sd > 0) return;
  std::ostringstream text;
  text << "FOCuS: standard deviation " << good.sd << " must be above 0";
  throw ConfigError(text.str());
}

void Focus::reset() { *this = Focus(good_); }

double Focus::add(double x) {
  if (std::isnan(x)) return statistic_;
  last_ = {last_.n + 1, last_.sum + (good_.mean - x) / good_.sd};
  maximize();
  push(last_);
  return statistic_;
}

/// Over the hull as it was before the last value: a change needs at least one value after it.
void Focus::maximize() {
  double best = 0;
  double best_run = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    const double rise = last_.sum - hull_[i].sum;
    const double run = last_.n - hull_[i].n;
    // compared as rise^2/run without the division
    if (rise > 0 && rise * rise * std::max(best_run, 1.0) > best * run) {
      best = rise * rise;
      best_run = run;
    }
  }
  statistic_ = best > 0 ? best / (2 * best_run) : 0;
  run_ = static_cast<std::uint32_t>(best_run);
}

/// Keeps the hull convex from below with rising slopes; slopes at or below 0 are no fall.
void Focus::push(const Vertex& vertex) {
  while (size_ > 0) {
    const Vertex& end = hull_[size_ - 1];
    const Vertex before = size_ > 1 ? hull_[size_ - 2] : Vertex{end.n - 1, end.sum};
    const double slope_in = (end.sum - before.sum) * (vertex.n - end.n);
    const double slope_out = (vertex.sum - end.sum) * (end.n - before.n);
    if (slope_out > slope_in) break;
    --size_;
  }
  if (size_ == 0) last_ = {0, 0};  // all earlier values are spent; start counting again
  if (size_ == capacity) {
    for (std::size_t i = 2; i < capacity; i += 2) hull_[i / 2] = hull_[i];
    size_ = capacity / 2;
  }
  hull_[size_++] = last_;
}

}  // namespace tocsin::decision
