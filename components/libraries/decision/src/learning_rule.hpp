// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "decision/policy.hpp"
#include "decision/site_learner.hpp"
#include "law_design.hpp"

namespace tocsin::decision {

/// A rule that learns the site's law beside another one, which decides. With laws `apply` that one
/// is made anew for the learned law when it is due: while active, with nothing suspected of the
/// link, so that no evidence is lost. That allocates and takes some milliseconds, a few times an
/// hour at most; all other samples take constant time and no memory.
class LearningRule final : public Rule {
 public:
  using Maker = std::unique_ptr<Rule> (*)(const PolicyParams&);
  /// Throws ConfigError as make_policy.
  LearningRule(const PolicyParams& params, Maker make);

  Decision while_active(double qni) override;
  Decision while_passive(double qni, int age) override;
  void entered(State state) override { rule_->entered(state); }
  void forget() override;
  [[nodiscard]] std::optional<LearnedLaw> learned() const override { return learner_.learned(); }

 private:
  void adopt(const Normal& law);

  Maker make_;
  std::unique_ptr<Rule> rule_;
  SiteLearner learner_;
  std::optional<LawDesign> design_;  // empty: laws are only proposed
};

}  // namespace tocsin::decision
