// SPDX-License-Identifier: Apache-2.0
#include "law_design.hpp"

#include "decision/policy_model.hpp"
#include "foundation/error.hpp"

namespace tocsin::decision {
namespace {

/// The same policy with its thresholds as numbers.
PolicyParams with_thresholds(const PolicyParams& params) {
  PolicyParams p = params;
  p.alpha = alpha_of(params);
  p.mild_alpha = mild_alpha_of(params);
  p.reverse_alpha = reverse_alpha_of(params);
  if (p.detector != "cusum") p.detector_threshold = detector_threshold_of(params);
  p.false_alarm_samples = p.false_resume_samples = p.mild_share = 0;
  return p;
}

}  // namespace

LawDesign::LawDesign(const PolicyParams& params)
    : params_(with_thresholds(params)),
      alarm_samples_(mean_run_length(step_law_of(params_, good_law_of(params_)), params_.alpha,
                                     params_.llr_clip == 0)),
      resume_samples_(mean_run_length(reverse_step_law_of(params_, bad_law_of(params_)),
                                      params_.reverse_alpha, params_.llr_clip == 0)),
      mild_depth_((params_.good_mean - params_.mild_mean) / params_.good_sd) {}

std::optional<PolicyParams> LawDesign::for_good(const Normal& good) const {
  if (!(good.mean > params_.bad_mean) || !(good.sd > 0)) return std::nullopt;
  const bool smooth = params_.llr_clip == 0;
  PolicyParams p = params_;
  p.good_mean = good.mean;
  p.good_sd = good.sd;
  p.mild_mean = good.mean - mild_depth_ * good.sd;
  p.alpha = rough_alpha_for_run_length(step_law_of(p, good_law_of(p)), alarm_samples_, smooth)
                .value_or(params_.alpha);
  p.reverse_alpha =
      rough_alpha_for_run_length(reverse_step_law_of(p, bad_law_of(p)), resume_samples_, smooth)
          .value_or(params_.reverse_alpha);
  if (p.detector == "shiryaev_roberts") p.detector_threshold += p.alpha - params_.alpha;
  return p;
}

}  // namespace tocsin::decision
