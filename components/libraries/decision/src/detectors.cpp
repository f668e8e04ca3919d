// SPDX-License-Identifier: Apache-2.0
#include "decision/detectors.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "decision/false_alarms.hpp"
#include "decision/policy_model.hpp"
#include "foundation/error.hpp"

namespace tocsin::decision {
namespace {

constexpr double simulated_samples = 2000;
constexpr Effort effort{400, 2 * simulated_samples};

std::unique_ptr<Detector> make_cusum(const PolicyParams& p) {
  return std::make_unique<CusumDetector>(llr_of(p));
}

Normal normal_good_law(const PolicyParams& p) {
  const Density good = good_law_of(p);
  if (good.family() == Family::normal) return {good.parameters()[0], good.parameters()[1]};
  throw ConfigError(std::string("policy.detector: focus needs a normal good law, not ") +
                    to_string(good.family()));
}

std::unique_ptr<Detector> make_focus(const PolicyParams& p) {
  return std::make_unique<Focus>(normal_good_law(p));
}

/// The threshold whose run length is `factor` times that of `h`: sqrt(h) exp(h) up to a constant.
double beyond_simulated(double h, double factor) {
  const auto log_run_length = [](double x) { return x - std::log(std::max(x, 1.0)) / 2; };
  const double target = log_run_length(h) + std::log(factor);
  for (int i = 0; i < 50; ++i) h += target - log_run_length(h);  // its slope is nearly 1
  return h;
}

double focus_threshold(const PolicyParams& p) {
  if (p.detector_threshold > 0) return p.detector_threshold;
  const double wanted = false_alarm_samples_of(p);
  const Normal good = normal_good_law(p);
  const auto source = independent(good, 1);
  Focus focus(good);
  const FalseAlarmCurve curve(*source, focus, effort);
  const double simulated = std::min(wanted, simulated_samples);
  const auto threshold = curve.threshold_for(simulated);
  if (threshold) return beyond_simulated(*threshold, wanted / simulated);
  std::ostringstream text;
  text << "policy.false_alarm_samples: " << wanted
       << ": cannot be had with detector focus, must be above " << curve.run_length(1e-6);
  throw ConfigError(text.str());
}

/// A detector: how it is made, and at which statistic it alarms. In the order of DetectorKind.
struct Row {
  std::unique_ptr<Detector> (*make)(const PolicyParams&);
  double (*threshold)(const PolicyParams&);
};
constexpr Row rows[] = {{make_cusum, alpha_of}, {make_focus, focus_threshold}};

const Row& row_of(const PolicyParams& p) { return rows[static_cast<std::size_t>(p.detector)]; }

}  // namespace

std::unique_ptr<Detector> detector_of(const PolicyParams& params) {
  return row_of(params).make(params);
}

double detector_threshold_of(const PolicyParams& params) {
  return row_of(params).threshold(params);
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
