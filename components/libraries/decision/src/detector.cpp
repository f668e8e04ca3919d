// SPDX-License-Identifier: Apache-2.0
#include "decision/detector.hpp"

#include <algorithm>
#include <cmath>

#include "special_functions.hpp"

namespace tocsin::decision {
namespace {

constexpr int score_cells = 1000;

}  // namespace

NormalScores::NormalScores(const Density& law) {
  const double below = law.cdf(0);
  const double mass = law.cdf(100) - below;
  for (int i = 0; i <= score_cells; ++i) {
    scores_.push_back(normal_quantile((law.cdf(100.0 * i / score_cells) - below) / mass));
  }
}

double NormalScores::operator()(double x) const {
  if (std::isnan(x)) return x;
  const double at = std::clamp(x, 0.0, 100.0) * score_cells / 100;
  const auto cell = std::min(static_cast<std::size_t>(at), scores_.size() - 2);
  const double share = at - static_cast<double>(cell);
  return scores_[cell] + share * (scores_[cell + 1] - scores_[cell]);
}

Detector Detector::focus(const Density& good) {
  if (good.family() == Family::normal) {
    return Detector(WithScores{nullptr, Focus({good.parameters()[0], good.parameters()[1]})});
  }
  return Detector(WithScores{std::make_shared<const NormalScores>(good), Focus({0, 1})});
}

double Detector::add(double qni) {
  if (auto* cusum = std::get_if<WithRatio<Cusum>>(&any_)) {
    return cusum->statistic.add(cusum->llr(qni));
  }
  if (auto* roberts = std::get_if<WithRatio<ShiryaevRoberts>>(&any_)) {
    return roberts->statistic.add(roberts->llr(qni));
  }
  auto& one = *std::get_if<WithScores>(&any_);
  return one.focus.add(one.scores ? (*one.scores)(qni) : qni);
}

void Detector::reset() {
  if (auto* cusum = std::get_if<WithRatio<Cusum>>(&any_)) {
    cusum->statistic.reset();
  } else if (auto* roberts = std::get_if<WithRatio<ShiryaevRoberts>>(&any_)) {
    roberts->statistic.reset();
  } else {
    std::get_if<WithScores>(&any_)->focus.reset();
  }
}

}  // namespace tocsin::decision
