// SPDX-License-Identifier: Apache-2.0
#include "decision/site_learner.hpp"

#include <algorithm>
#include <cmath>

#include "decision/policy_model.hpp"
#include "foundation/printable.hpp"

namespace tocsin::decision {
namespace {

constexpr double least_evidence = 3;  // standard errors
constexpr double least_worth = 30;    // effective ones
constexpr double least_shift = 0.25;  // of the mean, in spreads
constexpr double least_spread = 1.1;  // factor of the spread

/// Whether a policy would decide noticeably otherwise.
bool matters(const Normal& from, const Normal& to) {
  return std::abs(to.mean - from.mean) >= least_shift * from.sd ||
         std::max(to.sd / from.sd, from.sd / to.sd) >= least_spread;
}

/// With its sign.
std::string away(double standard_errors) {
  return (standard_errors > 0 ? "+" : "") + fixed_text(standard_errors, 0);
}

}  // namespace

std::string text_of(const Normal& good) {
  return "good_mean " + fixed_text(good.mean, 1) + ", good_sd " + fixed_text(good.sd, 1);
}

std::string text_of(const LearnedLaw& law) {
  const std::string worth = ", from samples worth " + fixed_text(law.effective_samples, 0);
  if (!law.proposed) return "nothing against " + text_of(law.configured) + worth;
  return "proposes " + text_of(law.learned) + " for " + text_of(law.configured) + ": mean " +
         away(law.evidence) + ", spread " + away(law.spread_evidence) + " standard errors away" +
         worth;
}

SiteLearner::SiteLearner(const PolicyParams& params)
    : learner_({params.good_mean, params.good_sd},
               {params.learn_memory_samples, params.learn_max_shift, params.learn_max_spread}),
      configured_{params.good_mean, params.good_sd},
      in_force_(configured_),
      llr_(llr_of(params)),
      alpha_(alpha_of(params)),
      memory_(params.learn_memory_samples) {}

void SiteLearner::add(double qni) {
  const double l = llr_(qni);
  if (std::isnan(l)) return;
  suspicion_ = std::clamp(suspicion_ + l, 0.0, alpha_);
  ++taken_;
  ++since_;
  if (suspicion_ >= alpha_ / 2) {
    ++left_out_;
  } else {
    learner_.add(qni);
  }
}

bool SiteLearner::is_proposed() const {
  const double evidence =
      std::max(std::abs(learner_.evidence()), std::abs(learner_.spread_evidence()));
  return evidence >= least_evidence && learner_.effective_samples() >= least_worth &&
         matters(configured_, learner_.law());
}

std::optional<Normal> SiteLearner::due() const {
  if (suspicion_ > 0 || since_ < memory_ / 10) return std::nullopt;
  const Normal law = is_proposed() ? learner_.law() : configured_;
  return matters(in_force_, law) ? std::optional<Normal>(law) : std::nullopt;
}

void SiteLearner::applied(const Normal& law) {
  in_force_ = law;
  since_ = 0;
  ++applied_;
}

LearnedLaw SiteLearner::learned() const {
  LearnedLaw learned{};
  learned.configured = configured_;
  learned.learned = learner_.law();
  learned.in_force = in_force_;
  learned.effective_samples = learner_.effective_samples();
  learned.evidence = learner_.evidence();
  learned.spread_evidence = learner_.spread_evidence();
  learned.left_out_share = taken_ > 0 ? left_out_ / taken_ : 0;
  learned.proposed = is_proposed();
  learned.applied = applied_;
  return learned;
}

}  // namespace tocsin::decision
