// SPDX-License-Identifier: Apache-2.0
#include "decision/policy_params.hpp"

#include <sstream>

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
  if (p.policy == PolicyKind::tocp && p.fixed_pause_samples > p.th_max_samples) {
    reject("fixed_pause_samples", p.fixed_pause_samples, "at most th_max_samples,",
           p.th_max_samples);
  }
  if (p.policy == PolicyKind::tocp_dsp && p.discount == DiscountKind::geometric &&
      !(p.discount_value > 0)) {
    reject("discount_value", p.discount_value, "with a geometric discount above", 0);
  }
}

void check_belief(const PolicyParams& p) {
  if (p.policy != PolicyKind::belief) return;
  if (!(p.cost_silent_bad < p.cost_send_bad)) {
    reject("cost_silent_bad", p.cost_silent_bad, "below cost_send_bad,", p.cost_send_bad);
  }
  if (p.th_max_samples > 1000) {
    reject("th_max_samples", p.th_max_samples, "with policy belief at most", 1000);
  }
}

}  // namespace

void check(const PolicyParams& params) {
  (void)llr_of(params);
  check_threshold(params);
  check_pause(params);
  check_belief(params);
}

}  // namespace tocsin::decision
