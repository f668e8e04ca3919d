// SPDX-License-Identifier: Apache-2.0
#include "foresight_rule.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "special_functions.hpp"

namespace tocsin::decision {
namespace {

constexpr double most_shadow = 4;
constexpr double level_step = 0.2;
constexpr double fading = 0.3;       // of the margin, which S does not tell
constexpr double least_gain = 0.05;  // of a loss: less is not worth a change
constexpr double doubt_alarm = 15;   // [nat] a run of shadowing has up to 10
constexpr double most_doubt = 20;    // [nat] so that a map that is right again is believed soon

double level_of(std::size_t i) { return -most_shadow + level_step * static_cast<double>(i); }

double lost_share(double margin) { return normal_cdf(-margin / fading); }

template <class Values>
void scale_to_one(Values& values) {
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  for (double& value : values) value /= sum;
}

/// Of nobody who has measured.
template <class Values>
void forget_all(Values& belief) {
  for (std::size_t i = 0; i < belief.size(); ++i) {
    belief[i] = std::exp(-level_of(i) * level_of(i) / 2);
  }
  scale_to_one(belief);
}

}  // namespace

ForesightRule::ForesightRule(const Llr& llr, const Costs& costs, std::unique_ptr<Rule> otherwise)
    : llr_(llr), costs_(costs), otherwise_(std::move(otherwise)), moves_(levels * levels) {
  forget_all(belief_);
  const double kept = std::exp(-1 / costs.correlation_s);
  const double deviation = std::sqrt(1 - kept * kept);
  for (std::size_t i = 0; i < levels; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < levels; ++j) {
      const double z = (level_of(j) - kept * level_of(i)) / deviation;
      sum += moves_[i * levels + j] = std::exp(-z * z / 2);
    }
    for (std::size_t j = 0; j < levels; ++j) moves_[i * levels + j] /= sum;
  }
}

double ForesightRule::margin(std::size_t step) const {
  constexpr double least = 0.005;  // a map promises no more than it was cut to
  const double risk = std::clamp(outlook_.risk_percent[step] / 100.0, least, 1 - least);
  return normal_quantile(1 - risk);
}

/// False where there is no outlook, or what is measured has contradicted it for long.
bool ForesightRule::foresees(double qni) {
  if (outlook_.size == 0) {
    forget_all(belief_);
    doubt_ = 0;
    return false;
  }
  learn(qni);
  return doubt_ < doubt_alarm;
}

void ForesightRule::learn(double qni) {
  Values moved{};
  for (std::size_t i = 0; i < levels; ++i) {
    for (std::size_t j = 0; j < levels; ++j) moved[j] += belief_[i] * moves_[i * levels + j];
  }
  belief_ = moved;
  if (std::isnan(qni)) return;
  const double ratio = std::exp(std::clamp(llr_(qni), -10.0, 10.0));
  doubt(ratio);
  for (std::size_t i = 0; i < levels; ++i) {
    const double lost = lost_share(margin(0) + level_of(i));
    belief_[i] *= 1 - lost + lost * ratio;
  }
  scale_to_one(belief_);
}

/// `ratio`: likelihood of the sample where the link is lost, over that where it is not.
void ForesightRule::doubt(double ratio) {
  const double risk = normal_cdf(-margin(0));
  const double evidence = std::log((0.5 + 0.5 * ratio) / (1 - risk + risk * ratio));
  doubt_ = std::clamp(doubt_ + evidence, 0.0, most_doubt);
}

ForesightRule::Values ForesightRule::after_move(const Values& next) const {
  Values mean{};
  for (std::size_t i = 0; i < levels; ++i) {
    for (std::size_t j = 0; j < levels; ++j) mean[i] += moves_[i * levels + j] * next[j];
  }
  return mean;
}

ForesightRule::Choice ForesightRule::choice() const {
  Values value{};  // of being at a step
  Values wait{};   // of waiting there
  for (std::size_t k = outlook_.size; k-- > 0;) {
    const double here = margin(k);
    const bool is_last = k + 1 == outlook_.size;
    if (!is_last) wait = after_move(value);
    for (std::size_t i = 0; i < levels; ++i) {
      const double send = lost_share(here + level_of(i));
      wait[i] = is_last ? send : wait[i] + costs_.wait_cost;
      value[i] = std::min(send, wait[i]);
    }
  }
  Choice choice{0, 0};
  for (std::size_t i = 0; i < levels; ++i) {
    choice.send += belief_[i] * lost_share(margin(0) + level_of(i));
    choice.wait += belief_[i] * wait[i];
  }
  return choice;
}

Decision ForesightRule::while_active(double qni) {
  if (!foresees(qni)) return otherwise_->while_active(qni);
  const Choice choice = this->choice();
  // What is foreseen alone begins no pause.
  const bool waits = !std::isnan(qni) && choice.wait < choice.send - least_gain;
  return {waits, waits ? Reason::better_ahead : Reason::steady, choice.send, choice.wait};
}

Decision ForesightRule::while_passive(double qni, int age) {
  if (!foresees(qni)) {
    const Decision decision = otherwise_->while_passive(qni, age);
    return {decision.change, decision.change ? Reason::no_outlook : decision.reason,
            decision.statistic, decision.threshold};
  }
  const Choice choice = this->choice();
  const bool sends = choice.send <= choice.wait + least_gain;
  return {sends, sends ? Reason::good_enough : Reason::steady, choice.send, choice.wait};
}

}  // namespace tocsin::decision
