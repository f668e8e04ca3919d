// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tocsin::decision {

/// Limits that hold for every policy.
struct PolicyLimits {
  int th_max_samples = 30;  ///< longest silence in samples
  double th_max_s = 180;    ///< longest silence in seconds
  double gap_reset_s = 60;  ///< a longer gap in samples voids the evidence for "turned bad"
};

/// Which policy decides, and its settings. Defaults: the thesis's laws at one sample per 6 s
/// (20 echoes, 0.3 s apart), a false alarm per 3600 good samples, silence of at most 3 minutes.
struct PolicyParams {
  std::string policy = "tocp_dsp";
  int th_max_samples = 30;
  double th_max_s = 180;
  double gap_reset_s = 60;
  double good_mean = 81.5669;
  double good_sd = 10.3309;
  double bad_mean = 36.5990;
  double bad_sd = 7.3819;
  double llr_clip = 0;
  double alpha = 5.53;
  double reverse_alpha = 3.86;
  std::string discount = "geometric";
  double discount_value = 0.95;
  int fixed_pause_samples = 30;
  double pause_below_qni = 40;
  double resume_at_qni = 50;
  int threshold_in_a_row = 1;

  template <class Visitor>
  void visit(Visitor& v) {
    v("policy", policy, {"none", "threshold", "tocp", "tocp_dsp", "tocp_reverse"},
      "who decides when to fall silent and when to resume");
    visit_limits(v);
    visit_detector(v);
    v("discount", discount, {"geometric", "linear"}, "tocp_dsp: how the worth of waiting fades");
    v("discount_value", discount_value, {0, 1},
      "[1] geometric: factor per sample; linear: loss over the longest pause");
    v("fixed_pause_samples", fixed_pause_samples, {1, 1000000}, "[1] tocp: length of a pause");
    v("pause_below_qni", pause_below_qni, {0, 100}, "[QNI] threshold: lower is bad");
    v("resume_at_qni", resume_at_qni, {0, 100}, "[QNI] threshold: this and higher is good");
    v("threshold_in_a_row", threshold_in_a_row, {1, 1000}, "[1] threshold: samples that agree");
  }

  [[nodiscard]] PolicyLimits limits() const { return {th_max_samples, th_max_s, gap_reset_s}; }

 private:
  template <class Visitor>
  void visit_limits(Visitor& v) {
    v("th_max_samples", th_max_samples, {1, 1000000}, "[1] longest silence in samples");
    v("th_max_s", th_max_s, {0.001, 86400}, "[s] longest silence");
    v("gap_reset_s", gap_reset_s, {0.001, 86400},
      "[s] a longer gap in samples voids earlier evidence");
  }
  template <class Visitor>
  void visit_detector(Visitor& v) {
    v("good_mean", good_mean, {0, 100}, "[QNI] mean of a good network");
    v("good_sd", good_sd, {0.01, 100}, "[QNI] standard deviation of a good network");
    v("bad_mean", bad_mean, {0, 100}, "[QNI] mean of a bad network");
    v("bad_sd", bad_sd, {0.01, 100}, "[QNI] standard deviation of a bad network");
    v("llr_clip", llr_clip, {0, 1000}, "[nat] bound on one log-likelihood ratio; 0 is none");
    v("alpha", alpha, {0.001, 1000}, "[nat] the CUSUM alarms at this sum");
    v("reverse_alpha", reverse_alpha, {0.001, 1000},
      "[nat] tocp_reverse: resumes at this sum of evidence for good");
  }
};

/// Checks the rules across fields; throws ConfigError naming the broken one.
void check(const PolicyParams& params);

}  // namespace tocsin::decision
