// SPDX-License-Identifier: Apache-2.0
#include "decision/policy_params.hpp"

#include <sstream>

#include "decision/cusum.hpp"
#include "decision/policy_model.hpp"
#include "foundation/error.hpp"

namespace tocsin::decision {
namespace {

[[noreturn]] void reject(const char* name, double value, const char* rule, double other) {
  std::ostringstream text;
  text << "policy." << name << ": " << value << " must be " << rule << ' ' << other;
  throw ConfigError(text.str());
}

void check_threshold(const PolicyParams& p) {
  if (!(p.pause_below_qni <= p.resume_at_qni)) {
    reject("pause_below_qni", p.pause_below_qni, "at most resume_at_qni,", p.resume_at_qni);
  }
}

void check_pause(const PolicyParams& p) {
  if (p.policy == "tocp" && p.fixed_pause_samples > p.th_max_samples) {
    reject("fixed_pause_samples", p.fixed_pause_samples, "at most th_max_samples,",
           p.th_max_samples);
  }
  if (p.policy == "tocp_dsp" && p.discount == "geometric" && !(p.discount_value > 0)) {
    reject("discount_value", p.discount_value, "with a geometric discount above", 0);
  }
}

void check_belief(const PolicyParams& p) {
  if (p.policy != "belief") return;
  if (!(p.cost_silent_bad < p.cost_send_bad)) {
    reject("cost_silent_bad", p.cost_silent_bad, "below cost_send_bad,", p.cost_send_bad);
  }
  if (p.th_max_samples > 1000) {
    reject("th_max_samples", p.th_max_samples, "with policy belief at most", 1000);
  }
}

[[noreturn]] void reject(const std::string& name, const std::string& value,
                         const std::string& rule) {
  throw ConfigError("policy." + name + ": " + value + ' ' + rule);
}

void check_learning(const PolicyParams& p) {
  if (p.laws == "fixed") return;
  if (good_law_of(p).family() != Family::normal || !p.good_parameters.empty()) {
    reject("laws", p.laws,
           "needs the good law as good_mean and good_sd, not as good_family " + p.good_family);
  }
  if (p.laws == "apply" && p.policy != "tocp" && p.policy != "tocp_dsp" &&
      p.policy != "tocp_reverse") {
    reject(
        "laws", p.laws,
        "needs policy tocp, tocp_dsp or tocp_reverse, not " + p.policy + "; propose goes with all");
  }
}

}  // namespace

void check(const PolicyParams& params) {
  (void)llr_of(params);
  if (params.mild_alpha > 0 || params.mild_share > 0) (void)mild_llr_of(params);
  check_threshold(params);
  check_pause(params);
  check_belief(params);
  check_learning(params);
}

}  // namespace tocsin::decision
