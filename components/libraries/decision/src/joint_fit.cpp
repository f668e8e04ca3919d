// SPDX-License-Identifier: Apache-2.0
#include "decision/joint_fit.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::decision {
namespace {

constexpr std::size_t least_samples = 50;
/// So that a reading that hardly moves on a quiet link is not thought exact: a loss in 400 probes,
/// 5 % of the round-trip time, 2 % of the channel's time, a decibel.
constexpr std::array<double, joint_readings> least_scale{0.05, 0.05, 0.05, 0.02, 1};

using Scores = std::vector<std::array<double, joint_readings>>;

Scores scores_of(const std::vector<JointIndexInput>& samples) {
  Scores scores;
  for (const JointIndexInput& sample : samples) scores.push_back(joint_scores(sample));
  return scores;
}

/// Of the scores that are numbers.
struct ScoreLaw {
  std::size_t count = 0;
  double mean = 0;
  double sd = 0;
};

template <class Values>
ScoreLaw score_law_of(const Values& values) {
  ScoreLaw m;
  double sum = 0;
  double squares = 0;
  for (const double x : values) {
    if (std::isnan(x)) continue;
    ++m.count;
    sum += x;
    squares += x * x;
  }
  const double n = std::max<double>(1, static_cast<double>(m.count));
  m.mean = sum / n;
  m.sd = std::sqrt(std::max(0.0, squares / n - m.mean * m.mean));
  return m;
}

std::vector<double> column(const Scores& scores, std::size_t reading) {
  std::vector<double> values;
  for (const auto& one : scores) values.push_back(one[reading]);
  return values;
}

/// Mean product of two standardised columns, `b` by `lag` samples later.
double correlation(const std::vector<double>& a, const std::vector<double>& b,
                   std::size_t lag = 0) {
  const ScoreLaw ma = score_law_of(a);
  const ScoreLaw mb = score_law_of(b);
  std::vector<double> products;
  for (std::size_t i = 0; i + lag < a.size(); ++i) {
    products.push_back((a[i] - ma.mean) * (b[i + lag] - mb.mean));
  }
  const double scale = ma.sd * mb.sd;
  return scale > 0 ? std::clamp(score_law_of(products).mean / scale, -0.99, 0.99) : 0;
}

/// Towards none: the share of the squared correlations that is chance.
double shrink(const Scores& scores, std::vector<double>& correlations) {
  double fading = 0;
  for (std::size_t i = 0; i < joint_readings; ++i) {
    const auto values = column(scores, i);
    fading = std::max(fading, correlation(values, values, 1));
  }
  const double n = static_cast<double>(scores.size()) * (1 - fading) / (1 + fading);
  double chance = 0;
  double squares = 0;
  for (const double r : correlations) {
    chance += (1 - r * r) * (1 - r * r) / std::max(1.0, n - 1);
    squares += r * r;
  }
  const double share = squares > 0 ? std::min(1.0, chance / squares) : 1;
  for (double& r : correlations) r *= 1 - share;
  return share;
}

Normal law_of(const JointIndex& index, const std::vector<JointIndexInput>& samples) {
  std::vector<double> values;
  for (const JointIndexInput& sample : samples) values.push_back(index.evaluate(sample));
  const ScoreLaw m = score_law_of(values);
  return {m.mean, std::max(1.0, m.sd)};
}

/// The standard deviation of the normal law with this mean whose worst hundredth begins where that
/// of `values` does: larger than theirs when their tail is heavy, on which false alarms hang. 0:
/// none.
double tail_sd(std::vector<double> values, double mean) {
  values.erase(std::remove_if(values.begin(), values.end(), [](double x) { return std::isnan(x); }),
               values.end());
  if (values.size() < least_samples) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 99 / 100);
  std::nth_element(values.begin(), at, values.end());
  return (*at - mean) / 2.326;
}

/// Centre, scale and correlation.
void set_good(const Scores& good, JointIndexParams& params) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < joint_readings; ++i) {
    const ScoreLaw law = score_law_of(column(good, i));
    params.joint_center[i] = law.mean;
    params.joint_scale[i] = std::max({law.sd, tail_sd(column(good, i), law.mean), least_scale[i]});
    for (std::size_t j = i + 1; j < joint_readings; ++j) {
      params.joint_correlation[at++] = correlation(column(good, i), column(good, j));
    }
  }
}

void add_falls(const Scores& good, const Scores& bad, JointIndexParams& params) {
  for (std::size_t i = 0; i < joint_readings; ++i) {
    const ScoreLaw after = score_law_of(column(bad, i));
    const bool told =
        score_law_of(column(good, i)).count >= least_samples && after.count >= least_samples;
    const double fall = (after.mean - params.joint_center[i]) / params.joint_scale[i];
    params.joint_fall.push_back(told ? std::max(0.0, fall) : 0);
  }
}

}  // namespace

JointFit fit_joint(const std::vector<JointIndexInput>& good,
                   const std::vector<std::vector<JointIndexInput>>& bad) {
  JointFit fit{};
  const Scores at_good = scores_of(good);
  set_good(at_good, fit.params);
  fit.params.joint_fall.clear();
  std::vector<JointIndexInput> all_bad;
  for (const auto& kind : bad) {
    add_falls(at_good, scores_of(kind), fit.params);
    all_bad.insert(all_bad.end(), kind.begin(), kind.end());
  }
  fit.shrinkage = shrink(at_good, fit.params.joint_correlation);
  const JointIndex index(fit.params);
  fit.good = law_of(index, good);
  fit.bad = law_of(index, all_bad);
  return fit;
}

}  // namespace tocsin::decision
