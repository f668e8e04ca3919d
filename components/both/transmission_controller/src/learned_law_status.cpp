// SPDX-License-Identifier: Apache-2.0
#include "learned_law_status.hpp"

#include <utility>

#include "foundation/printable.hpp"

namespace tocsin {
namespace {

using diagnostic_msgs::msg::DiagnosticStatus;

void add(DiagnosticStatus& status, const char* key, double value, int digits) {
  diagnostic_msgs::msg::KeyValue pair;
  pair.key(key);
  pair.value(fixed_text(value, digits));
  status.values().push_back(std::move(pair));
}

}  // namespace

DiagnosticStatus status_of(const decision::LearnedLaw& law, const std::string& owner) {
  DiagnosticStatus status;
  status.level(diagnostic_msgs::msg::DiagnosticStatus_Constants::OK);
  status.name(owner + ": laws");
  status.message(text_of(law));
  add(status, "configured_mean", law.configured.mean, 2);
  add(status, "configured_sd", law.configured.sd, 2);
  add(status, "learned_mean", law.learned.mean, 2);
  add(status, "learned_sd", law.learned.sd, 2);
  add(status, "in_force_mean", law.in_force.mean, 2);
  add(status, "in_force_sd", law.in_force.sd, 2);
  add(status, "evidence", law.evidence, 1);
  add(status, "spread_evidence", law.spread_evidence, 1);
  add(status, "effective_samples", law.effective_samples, 0);
  add(status, "left_out_percent", 100 * law.left_out_share, 1);
  add(status, "applied", law.applied, 0);
  return status;
}

}  // namespace tocsin
