// SPDX-License-Identifier: Apache-2.0
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

/// The threshold whose run length is `factor` times that of `h`: sqrt(h) exp(h) up to a constant.
double beyond_focus(double h, double factor) {
  const auto log_run_length = [](double x) { return x - std::log(std::max(x, 1.0)) / 2; };
  const double target = log_run_length(h) + std::log(factor);
  for (int i = 0; i < 50; ++i) h += target - log_run_length(h);  // its slope is nearly 1
  return h;
}

/// The same for Shiryaev-Roberts, whose run length keeps its ratio to that of the CUSUM.
double beyond_roberts(const PolicyParams& p, double h, double samples, double factor) {
  if (factor <= 1) return h;
  const bool smooth = p.llr_clip == 0;
  const StepLaw law = step_law_of(p, good_law_of(p));
  const double alpha = alpha_for_run_length(law, samples, smooth);
  return h + alpha_for_run_length(law, samples * factor, smooth) - alpha;
}

[[noreturn]] void reject(const PolicyParams& p, double wanted, double least) {
  std::ostringstream text;
  text << "policy.false_alarm_samples: " << wanted << ": cannot be had with detector " << p.detector
       << ", must be above " << least;
  throw ConfigError(text.str());
}

}  // namespace

Detector detector_of(const PolicyParams& p) {
  if (p.detector == "focus") return Detector::focus(good_law_of(p));
  if (p.detector == "shiryaev_roberts") return Detector::shiryaev_roberts(llr_of(p));
  return Detector::cusum(llr_of(p));
}

double detector_threshold_of(const PolicyParams& p) {
  if (p.detector == "cusum") return alpha_of(p);
  if (p.detector_threshold > 0) return p.detector_threshold;
  const double wanted = false_alarm_samples_of(p) / (1 - p.mild_share);
  const auto source = independent(good_law_of(p), 1);
  const FalseAlarmCurve curve(*source, detector_of(p), effort);
  const double simulated = std::min(wanted, simulated_samples);
  const auto threshold = curve.threshold_for(simulated);
  if (!threshold) reject(p, wanted, curve.run_length(1e-6));
  const double factor = wanted / simulated;
  return p.detector == "focus" ? beyond_focus(*threshold, factor)
                               : beyond_roberts(p, *threshold, simulated, factor);
}

}  // namespace tocsin::decision
