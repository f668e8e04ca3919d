// SPDX-License-Identifier: Apache-2.0
#include "recording_calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "decision/policy_model.hpp"
#include "foundation/error.hpp"
#include "foundation/numbers.hpp"
#include "foundation/printable.hpp"

namespace tocsin::tools {
namespace {

using decision::Calibration;
using decision::Residuals;

double period_of(const QualityTrace& trace) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < trace.time_s.size(); ++i) {
    steps.push_back(trace.time_s[i] - trace.time_s[i - 1]);
  }
  if (steps.empty()) return 0;
  std::nth_element(steps.begin(), steps.begin() + static_cast<long>(steps.size() / 2), steps.end());
  return steps[steps.size() / 2];
}

std::vector<double> qualities_of(const QualityTrace& trace, double period_s) {
  std::vector<double> qualities;
  for (std::size_t i = 0; i < trace.qni.size(); ++i) {
    if (i > 0 && trace.time_s[i] - trace.time_s[i - 1] > 1.5 * period_s) qualities.push_back(nan);
    qualities.push_back(trace.qni[i]);
  }
  return qualities;
}

std::string model_text(const decision::LinkModel& model) {
  if (const auto* ar1 = std::get_if<decision::Ar1Link>(&model)) {
    return fmt::format("a normal law {:.4g} +-{:.3g} with correlation {:.3g} of neighbours",
                       ar1->law.mean, ar1->law.sd, ar1->correlation);
  }
  if (const auto* two = std::get_if<decision::TwoStateLink>(&model)) {
    return fmt::format(
        "two states, {:.4g} +-{:.3g} for {:.3g} samples and {:.4g} +-{:.3g} for {:.3g}",
        two->high.mean, two->high.sd, 1 / two->high_to_low, two->low.mean, two->low.sd,
        1 / two->low_to_high);
  }
  return fmt::format("its own blocks of {} samples, strung together anew",
                     std::get<decision::BlockLink>(model).block);
}

std::string residuals_text(const char* name, const Residuals& r) {
  return fmt::format("{} {} (distance {:.3f}, correlation {:+.2f})", name,
                     r.sound ? "holds" : "does not hold", r.ks, r.correlation);
}

/// What is not in the recording and had to be assumed.
std::string extrapolation_text(const Calibration& c) {
  if (!c.extrapolated()) return "";
  return "  extrapolated: the recording is shorter than ten false-alarm times, so that the "
         "threshold rests on the\n  model's tail and not on false alarms that were seen\n";
}

/// [samples]; 0 when the calibration is to choose it.
int block_of(const CalibrationWish& wish, double period_s, std::size_t samples) {
  if (!(wish.block_s > 0)) return 0;
  const double block = std::round(wish.block_s / period_s);
  if (block >= 1 && block <= static_cast<double>(samples)) return static_cast<int>(block);
  throw ConfigError(fmt::format(
      "--block: {} s must be at least one sample, {} s, and at most the recording, {} s",
      shortest_text(wish.block_s), shortest_text(period_s),
      shortest_text(static_cast<double>(samples) * period_s)));
}

}  // namespace

RecordingCalibration calibrate_on(const QualityTrace& recording, const CalibrationWish& wish) {
  const double period_s = period_of(recording);
  if (!(period_s > 0)) throw ConfigError(recording.path + ": its time does not advance");
  decision::CalibrationRequest request{qualities_of(recording, period_s), detector_of(wish.params),
                                       wish.false_alarm_s / period_s};
  request.block = block_of(wish, period_s, recording.qni.size());
  request.seed = wish.seed;
  request.replicates = wish.replicates;
  request.paths = wish.paths;
  try {
    const bool cusum = wish.params.detector == decision::DetectorKind::cusum;
    return {recording.path, cusum ? "alpha" : "detector_threshold", period_s, wish.false_alarm_s,
            decision::calibrate(request)};
  } catch (const ConfigError& error) {
    throw ConfigError(recording.path + ": " + error.what());
  }
}

std::string to_text(const RecordingCalibration& one) {
  const Calibration& c = one.found;
  const std::string length = duration_text(c.held_samples * one.period_s);
  std::string text = fmt::format(
      "calibrated on {} ({} at {} s), simulated as {}\n  forecasts of its next sample: {}; {}\n",
      one.file, length, one.period_s, model_text(c.fit.model),
      residuals_text("ar1", c.fit.ar1_residuals),
      residuals_text("two_state", c.fit.two_state_residuals));
  if (c.any_threshold) {
    return text + fmt::format(
                      "  it holds too little that looks bad: any {} has fewer false alarms "
                      "than wanted, one in {} or less\n",
                      one.parameter, duration_text(c.true_samples.low * one.period_s));
  }
  text += fmt::format(
      "  {} {:.5g}: a false alarm per {}; with 95 % confidence the link's own time is {} to {}\n",
      one.parameter, c.threshold, duration_text(one.false_alarm_s),
      duration_text(c.true_samples.low * one.period_s),
      duration_text(c.true_samples.high * one.period_s));
  text += fmt::format("  the recording itself has {} alarms at it, of {:.2g} to be expected\n",
                      c.alarms_seen, c.held_samples / c.wanted_samples);
  return text + extrapolation_text(c) +
         fmt::format("  +-20 % needs a recording of about {} (this one: {})\n",
                     duration_text(c.needed_samples * one.period_s), length);
}

nlohmann::json to_json(const RecordingCalibration& one) {
  const Calibration& c = one.found;
  return {{"file", one.file},
          {one.parameter, c.threshold},
          {"false_alarm_s", one.false_alarm_s},
          {"period_s", one.period_s},
          {"recording_s", c.held_samples * one.period_s},
          {"model", name_of(c.fit.model)},
          {"ar1_holds", c.fit.ar1_residuals.sound},
          {"two_state_holds", c.fit.two_state_residuals.sound},
          {"alarms_seen", c.alarms_seen},
          {"extrapolated", c.extrapolated()},
          {"any_threshold", c.any_threshold},
          {"true_low_s", c.true_samples.low * one.period_s},
          {"true_high_s", c.true_samples.high * one.period_s},
          {"needed_s", c.needed_samples * one.period_s}};
}

std::string duration_text(double s) {
  if (s < 120) return fmt::format("{:.4g} s", s);
  if (s < 7200) return fmt::format("{:.4g} min", s / 60);
  if (s < 172800) return fmt::format("{:.4g} h", s / 3600);
  return fmt::format("{:.4g} d", s / 86400);
}

}  // namespace tocsin::tools
