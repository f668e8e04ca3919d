// SPDX-License-Identifier: Apache-2.0
#include "decision/design/calibration.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace tocsin::decision {
namespace {

constexpr double least_threshold = 1e-6;
constexpr double wide = 1.2;  // the accuracy for which needed_samples is stated

/// `effort` in wanted run lengths.
FalseAlarmCurve curve_of(const LinkModel& model, const CalibrationRequest& request,
                         const Effort& effort, std::uint64_t seed) {
  const auto source = source_of(model, seed);
  return {*source, *request.detector, {effort.paths, effort.horizon * request.samples}};
}

std::vector<double> draw(const LinkModel& model, std::size_t size, std::uint64_t seed) {
  const auto source = source_of(model, seed);
  std::vector<double> qualities(size);
  for (double& one : qualities) one = source->next();
  return qualities;
}

/// Mean and spread of ln(true / estimated run length) over recordings that might have been.
struct Spread {
  double mean = 0;
  double variance = 0;
};

/// The simulations' own error, which is in the replicates and not in a recording, is taken out.
Spread spread_of(const std::vector<double>& logs, double simulation_variance) {
  Spread spread;
  const double n = static_cast<double>(logs.size());
  for (const double one : logs) spread.mean += one / n;
  for (const double one : logs) {
    spread.variance += (one - spread.mean) * (one - spread.mean) / (n - 1);
  }
  spread.variance = std::max(spread.variance - simulation_variance, spread.variance / 4);
  return spread;
}

Spread replicate(const CalibrationRequest& request, const LinkModel& model,
                 const FalseAlarmCurve& truth) {
  constexpr int paths = 100;
  std::vector<double> logs;
  double alarms = 0;
  for (int i = 0; i < request.replicates; ++i) {
    const auto seed = request.seed + 1000 + 2 * static_cast<std::uint64_t>(i);
    const auto again = draw(model, request.qualities.size(), seed);
    const auto curve = curve_of(fit_like(model, again), request, {paths, 1.5}, seed + 1);
    const double threshold = curve.threshold_for(request.samples).value_or(least_threshold);
    alarms += std::max(1, curve.alarms(threshold));
    logs.push_back(std::log(truth.run_length(threshold) / curve.run_length(threshold)));
  }
  return spread_of(logs, static_cast<double>(request.replicates) / alarms);
}

/// Half of the interval of the logarithm: the recording's spread, the replicates' number, and the
/// error of `curve`, which moves the threshold one way and the replicates' mean the other.
double half_of(const Spread& spread, int replicates, int alarms) {
  const double variance = spread.variance * (1 + 1.0 / replicates) + 4.0 / std::max(1, alarms);
  return quantile(boost::math::students_t(replicates - 1), 0.975) * std::sqrt(variance);
}

int alarms_in(const std::vector<double>& qualities, Detector& detector, double threshold) {
  int alarms = 0;
  detector.reset();
  for (const double x : qualities) {
    if (detector.add(x) < threshold) continue;
    ++alarms;
    detector.reset();
  }
  return alarms;
}

}  // namespace

Calibration calibrate(const CalibrationRequest& request) {
  Calibration result{};
  result.fit = fit_link(request.qualities, request.block);
  result.wanted_samples = request.samples;
  result.held_samples = static_cast<double>(std::count_if(
      request.qualities.begin(), request.qualities.end(), [](double x) { return !std::isnan(x); }));
  const FalseAlarmCurve curve =
      curve_of(result.fit.model, request, {request.paths, 2}, request.seed);
  const auto threshold = curve.threshold_for(request.samples);
  result.any_threshold = !threshold;
  result.threshold = threshold.value_or(least_threshold);
  result.alarms_seen = alarms_in(request.qualities, *request.detector, result.threshold);
  const double estimate = curve.run_length(result.threshold);
  const Spread spread = replicate(request, result.fit.model, curve);
  const double half = half_of(spread, request.replicates, curve.alarms(result.threshold));
  result.true_samples = {estimate * std::exp(spread.mean - half),
                         estimate * std::exp(spread.mean + half)};
  const double share = 1.96 / std::log(wide);
  result.needed_samples = result.held_samples * spread.variance * share * share;
  return result;
}

}  // namespace tocsin::decision
