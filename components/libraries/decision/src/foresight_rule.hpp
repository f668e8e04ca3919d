// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "decision/llr.hpp"
#include "decision/outlook.hpp"
#include "decision/policy.hpp"

namespace tocsin::decision {

/// Sends now or waits for a better place on the way: optimal stopping with full knowledge of the
/// law along the path.
///
/// A place's margin is that of a normal law whose chance to be below zero is the outlook's risk,
/// plus the shadowing S, of mean 0 and variance 1, which is a Markov chain along the way: S' = r S
/// + sqrt(1 - r^2) w, r = exp(-1 s / correlation) (Muralidharan and Mostofi 2018). Each sample
/// tells of S by Bayes' rule: the bad law holds below zero, the good one above. Sending costs the
/// chance of a loss, a second of waiting costs `wait_cost`; backward induction over the outlook and
/// the levels of S says which is less.
///
/// Where samples contradict the outlook for long (a CUSUM of the likelihood ratio against a link of
/// which nothing is known, as in TOCP), the map is wrong; then, and without an outlook, another
/// rule decides.
class ForesightRule final : public Rule {
 public:
  struct Costs {
    double wait_cost;      ///< of a second, beside 1 for a loss
    double correlation_s;  ///< of shadowing on the way
  };
  ForesightRule(const Llr& llr, const Costs& costs, std::unique_ptr<Rule> otherwise);

  Decision while_active(double qni) override;
  Decision while_passive(double qni, int age) override;
  void entered(State state) override { otherwise_->entered(state); }
  void forget() override { otherwise_->forget(); }
  void foresee(const Outlook& outlook) override { outlook_ = outlook; }

 private:
  static constexpr std::size_t levels = 41;  ///< of S, from -4 to 4
  using Values = std::array<double, levels>;
  /// What sending now and waiting cost.
  struct Choice {
    double send;
    double wait;
  };
  [[nodiscard]] bool foresees(double qni);
  void learn(double qni);
  void doubt(double ratio);
  [[nodiscard]] Choice choice() const;
  [[nodiscard]] double margin(std::size_t step) const;
  /// The mean of the next step's values, from each level.
  [[nodiscard]] Values after_move(const Values& next) const;

  Llr llr_;
  Costs costs_;
  std::unique_ptr<Rule> otherwise_;
  std::vector<double> moves_;  ///< chance from level i to level j
  Outlook outlook_;
  Values belief_;  ///< in each level
  double doubt_ = 0;
};

}  // namespace tocsin::decision
