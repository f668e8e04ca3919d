// SPDX-License-Identifier: Apache-2.0
#include "learning_rule.hpp"

#include "foundation/error.hpp"

namespace tocsin::decision {

LearningRule::LearningRule(const PolicyParams& params, Maker make)
    : make_(make), rule_(make(params)), learner_(params) {
  if (params.laws == "apply") design_.emplace(params);
}

Decision LearningRule::while_active(double qni) {
  learner_.add(qni);
  const Decision decision = rule_->while_active(qni);
  const bool quiet = !decision.change && decision.statistic <= decision.threshold / 4;
  if (!design_ || !quiet) return decision;
  if (const auto law = learner_.due()) adopt(*law);
  return decision;
}

Decision LearningRule::while_passive(double qni, int age) {
  learner_.add(qni);
  return rule_->while_passive(qni, age);
}

void LearningRule::forget() {
  rule_->forget();
  learner_.forget();
}

void LearningRule::adopt(const Normal& law) {
  const auto params = design_->for_good(law);
  if (!params) return learner_.refused();
  rule_ = make_(*params);
  learner_.applied(law);
}

}  // namespace tocsin::decision
