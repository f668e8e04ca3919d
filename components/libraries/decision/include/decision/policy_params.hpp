// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "decision/detectors.hpp"
#include "decision/slot_costs.hpp"
#include "foundation/enum_words.hpp"
#include "foundation/parameters.hpp"

namespace tocsin::decision {

/// Limits that hold for every policy.
struct PolicyLimits {
  int th_max_samples = 30;  ///< longest silence in samples
  double th_max_s = 180;    ///< longest silence in seconds
  double gap_reset_s = 60;  ///< a longer gap in samples voids the evidence for "turned bad"
};

enum class PolicyKind { none, threshold, tocp, tocp_dsp, tocp_reverse, belief, legacy, foresight };
inline constexpr auto words_of(PolicyKind) {
  return std::array{"none",         "threshold", "tocp",   "tocp_dsp",
                    "tocp_reverse", "belief",    "legacy", "foresight"};
}
/// Every policy that make_policy knows.
inline constexpr Choices policy_names{"none",         "threshold", "tocp",   "tocp_dsp",
                                      "tocp_reverse", "belief",    "legacy", "foresight"};

/// Who decides in policy foresight where nothing can be foreseen.
enum class FallbackKind { none, tocp_dsp };
inline constexpr auto words_of(FallbackKind) { return std::array{"none", "tocp_dsp"}; }

/// How the worth of waiting fades in tocp_dsp.
enum class DiscountKind { geometric, linear };
inline constexpr auto words_of(DiscountKind) { return std::array{"geometric", "linear"}; }

/// Which policy decides, and its settings. Defaults: no policy, because beside the link router it
/// is the one that costs users least (experiment's README); for the others the thesis's laws at one
/// sample per 6 s (20 echoes, 0.3 s apart), a false alarm per 3600 good samples, silence of at most
/// 3 minutes.
struct PolicyParams {
  PolicyKind policy = PolicyKind::none;
  int th_max_samples = 30;
  double th_max_s = 180;
  double gap_reset_s = 60;
  double good_mean = 81.5669;
  double good_sd = 10.3309;
  double bad_mean = 36.5990;
  double bad_sd = 7.3819;
  std::string good_family = "normal";
  std::vector<double> good_parameters;
  std::string bad_family = "normal";
  std::vector<double> bad_parameters;
  double llr_clip = 0;
  DetectorKind detector = DetectorKind::cusum;
  double detector_threshold = 0;
  double alpha = 5.53;
  double reverse_alpha = 3.86;
  double false_alarm_samples = 0;
  double false_resume_samples = 0;
  DiscountKind discount = DiscountKind::geometric;
  double discount_value = 0.95;
  int fixed_pause_samples = 30;
  double pause_below_qni = 40;
  double resume_at_qni = 50;
  int threshold_in_a_row = 1;
  double mean_good_samples = 120;
  double mean_bad_samples = 20;
  double cost_send_bad = 1;
  double cost_silent_good = 0.5;
  double cost_silent_bad = 0.1;
  double cost_change = 0.5;
  bool belief_myopic = false;
  FallbackKind foresight_fallback = FallbackKind::none;
  double foresight_wait_cost = 0.01;
  double foresight_correlation_s = 6;

  template <class Visitor>
  void visit(Visitor& v) {
    visit_enum(v, "policy", policy, policy_names,
               "who decides when to fall silent and when to resume");
    visit_limits(v);
    visit_laws(v);
    visit_detector(v);
    visit_resume(v);
    visit_belief(v);
    visit_foresight(v);
  }

  [[nodiscard]] PolicyLimits limits() const { return {th_max_samples, th_max_s, gap_reset_s}; }
  [[nodiscard]] SlotCosts costs() const {
    return {cost_send_bad, cost_silent_good, cost_silent_bad, cost_change};
  }

 private:
  template <class Visitor>
  void visit_limits(Visitor& v) {
    v("th_max_samples", th_max_samples, {1, 1000000}, "[1] longest silence in samples");
    v("th_max_s", th_max_s, {0.001, 86400}, "[s] longest silence");
    v("gap_reset_s", gap_reset_s, {0.001, 86400},
      "[s] a longer gap in samples voids earlier evidence");
  }
  template <class Visitor>
  void visit_laws(Visitor& v) {
    v("good_mean", good_mean, {0, 100}, "[QNI] mean of a good network, for family normal");
    v("good_sd", good_sd, {0.01, 100}, "[QNI] its standard deviation");
    v("bad_mean", bad_mean, {0, 100}, "[QNI] mean of a bad network, for family normal");
    v("bad_sd", bad_sd, {0.01, 100}, "[QNI] its standard deviation");
    v("good_family", good_family, "law of a good network, as tocsin fit names it");
    v("good_parameters", good_parameters, {-1e7, 1e7},
      "parameters of good_family; empty for normal with good_mean and good_sd");
    v("bad_family", bad_family, "law of a bad network, as tocsin fit names it");
    v("bad_parameters", bad_parameters, {-1e7, 1e7},
      "parameters of bad_family; empty for normal with bad_mean and bad_sd");
    v("llr_clip", llr_clip, {0, 1000}, "[nat] bound on one log-likelihood ratio; 0 is none");
  }
  template <class Visitor>
  void visit_detector(Visitor& v) {
    visit_enum(v, "detector", detector, detector_names,
               "tocp, tocp_dsp, tocp_reverse: cusum for a change to the bad law, focus for a fall "
               "of unknown size");
    v("detector_threshold", detector_threshold, {0, 10000},
      "[nat] focus alarms here; 0: as rarely as alpha or false_alarm_samples say, on independent "
      "samples");
    v("alpha", alpha, {0.001, 1000}, "[nat] the CUSUM alarms at this sum");
    v("reverse_alpha", reverse_alpha, {0.001, 1000},
      "[nat] tocp_reverse: resumes at this sum of evidence for good");
    v("false_alarm_samples", false_alarm_samples, {0, 1e12},
      "[1] wanted mean samples between false alarms, replaces alpha; 0 is as alpha says");
    v("false_resume_samples", false_resume_samples, {0, 1e12},
      "[1] tocp_reverse: the same for resuming in a bad network; 0 is as reverse_alpha says");
  }
  template <class Visitor>
  void visit_resume(Visitor& v) {
    visit_enum(v, "discount", discount, Choices{"geometric", "linear"},
               "tocp_dsp: how the worth of waiting fades");
    v("discount_value", discount_value, {0, 1},
      "[1] geometric: factor per sample; linear: loss over the longest pause");
    v("fixed_pause_samples", fixed_pause_samples, {1, 1000000}, "[1] tocp: length of a pause");
    v("pause_below_qni", pause_below_qni, {0, 100}, "[QNI] threshold: lower is bad");
    v("resume_at_qni", resume_at_qni, {0, 100}, "[QNI] threshold: this and higher is good");
    v("threshold_in_a_row", threshold_in_a_row, {1, 1000}, "[1] threshold: samples that agree");
  }
  template <class Visitor>
  void visit_belief(Visitor& v) {
    v("mean_good_samples", mean_good_samples, {1.001, 1e9}, "[1] belief: mean length of good");
    v("mean_bad_samples", mean_bad_samples, {1.001, 1e9}, "[1] belief: mean length of bad");
    v("cost_send_bad", cost_send_bad, {0, 1e6}, "[1] cost of a slot spoken in a bad network");
    v("cost_silent_good", cost_silent_good, {0, 1e6}, "[1] cost of a silent slot in a good one");
    v("cost_silent_bad", cost_silent_bad, {0, 1e6}, "[1] cost of a silent slot in a bad one");
    v("cost_change", cost_change, {0, 1e6}, "[1] cost of each change");
    v("belief_myopic", belief_myopic, "belief: ignore cost_change and the age of silence");
  }
  template <class Visitor>
  void visit_foresight(Visitor& v) {
    visit_enum(v, "foresight_fallback", foresight_fallback, Choices{"none", "tocp_dsp"},
               "foresight: who decides where nothing can be foreseen");
    v("foresight_wait_cost", foresight_wait_cost, {0.0001, 1},
      "[1/s] foresight: cost of a second of waiting; of a loss it is 1");
    v("foresight_correlation_s", foresight_correlation_s, {1, 60},
      "[s] foresight: shadowing forgets on the way, by 1/e");
  }
};

/// Checks the rules across fields; throws ConfigError naming the broken one.
void check(const PolicyParams& params);

}  // namespace tocsin::decision
