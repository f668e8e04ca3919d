// SPDX-License-Identifier: Apache-2.0
#include "decision/design/link_model.hpp"

#include <algorithm>
#include <boost/random/uniform_01.hpp>
#include <cmath>
#include <random>

#include "held_normal.hpp"
#include "special_functions.hpp"

namespace tocsin::decision {
namespace {

double square(double x) { return x * x; }

/// What is foretold, collected forecast by forecast.
class Forecasts {
 public:
  /// `u` is where in the forecast's distribution the quality came, `log_density` how likely it was.
  void add(double below, double up_to, double log_density) {
    log_likelihood_ += log_density;
    const double u = below + (up_to - below) * uniform_(random_);  // held: anywhere in its share
    uniform_scores_.push_back(u);
    normal_scores_.push_back(normal_quantile(u));
  }
  [[nodiscard]] Residuals residuals(int parameters) const {
    const double n = std::max(1.0, static_cast<double>(uniform_scores_.size()));
    Residuals result{};
    result.log_likelihood = log_likelihood_;
    result.bic = parameters * std::log(n) - 2 * log_likelihood_;
    result.ks = ks();
    for (std::size_t lag = 1; lag <= 5; ++lag) {
      const double one = correlation(lag);
      if (std::abs(one) > std::abs(result.correlation)) result.correlation = one;
    }
    // 1.36 and 3 standard errors; what is smaller than the second number does not matter
    result.sound = result.ks <= std::max(1.36 / std::sqrt(n), 0.02) &&
                   std::abs(result.correlation) <= std::max(3 / std::sqrt(n), 0.05);
    return result;
  }

 private:
  [[nodiscard]] double ks() const {
    std::vector<double> sorted = uniform_scores_;
    std::sort(sorted.begin(), sorted.end());
    const double n = static_cast<double>(sorted.size());
    double worst = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const double before = static_cast<double>(i);
      worst = std::max({worst, sorted[i] - before / n, (before + 1) / n - sorted[i]});
    }
    return worst;
  }
  [[nodiscard]] double correlation(std::size_t lag) const {
    double top = 0;
    double bottom = 1e-12;
    for (std::size_t i = 0; i < normal_scores_.size(); ++i) {
      bottom += square(normal_scores_[i]);
      if (i >= lag) top += normal_scores_[i] * normal_scores_[i - lag];
    }
    return top / bottom;
  }

  std::mt19937_64 random_{1};  // NOLINT: the same residuals each time
  boost::random::uniform_01<double> uniform_;
  double log_likelihood_ = 0;
  std::vector<double> uniform_scores_;
  std::vector<double> normal_scores_;
};

}  // namespace

const char* name_of(const LinkModel& model) {
  if (std::holds_alternative<Ar1Link>(model)) return "ar1";
  return std::holds_alternative<TwoStateLink>(model) ? "two_state" : "blocks";
}

int parameter_count(const LinkModel& model) {
  if (std::holds_alternative<Ar1Link>(model)) return 3;
  return std::holds_alternative<TwoStateLink>(model) ? 6 : 0;
}

Residuals residuals_of(const Ar1Link& model, const std::vector<double>& qualities) {
  Forecasts forecasts;
  const double variance = square(model.law.sd);
  HeldNormal before{model.law.mean, variance};
  for (const double x : qualities) {
    const double phi = model.correlation;
    const HeldNormal ahead{model.law.mean + phi * (before.mean - model.law.mean),
                           variance * (1 - phi * phi) + phi * phi * before.variance};
    if (std::isnan(x)) {
      before = ahead;
      continue;
    }
    forecasts.add(ahead.below(x), ahead.up_to(x), ahead.log_density(x));
    before = meant_by(x, model.law);
  }
  return forecasts.residuals(3);
}

Residuals residuals_of(const TwoStateLink& model, const std::vector<double>& qualities) {
  Forecasts forecasts;
  const HeldNormal high{model.high.mean, square(model.high.sd)};
  const HeldNormal low{model.low.mean, square(model.low.sd)};
  double p = model.high_to_low / (model.high_to_low + model.low_to_high);  // of the state low
  for (const double x : qualities) {
    if (!std::isnan(x)) {
      const double of_low = p * std::exp(low.log_density(x));
      const double all = std::max(of_low + (1 - p) * std::exp(high.log_density(x)), 1e-300);
      forecasts.add(p * low.below(x) + (1 - p) * high.below(x),
                    p * low.up_to(x) + (1 - p) * high.up_to(x), std::log(all));
      p = of_low / all;
    }
    p = p * (1 - model.low_to_high) + (1 - p) * model.high_to_low;
  }
  return forecasts.residuals(6);
}

int block_for(const std::vector<double>& qualities) {
  std::vector<double> x;
  double mean = 0;
  for (const double one : qualities) {
    if (std::isnan(one)) continue;
    x.push_back(one);
    mean += one;
  }
  mean /= std::max(1.0, static_cast<double>(x.size()));
  const auto covariance = [&](std::size_t lag) {
    double sum = 0;
    for (std::size_t i = lag; i < x.size(); ++i) sum += (x[i] - mean) * (x[i - lag] - mean);
    return sum;
  };
  const double variance = covariance(0);
  std::size_t lag = 1;
  while (lag < x.size() / 100 && covariance(lag) > variance / M_E) ++lag;
  const auto most = std::max<std::size_t>(1, x.size() / 10);
  return static_cast<int>(std::min(std::max<std::size_t>(10, 10 * lag), most));
}

LinkFit fit_link(const std::vector<double>& qualities, int block) {
  LinkFit fit{};
  fit.ar1 = fit_ar1(qualities);
  fit.ar1_residuals = residuals_of(fit.ar1, qualities);
  fit.two_state = fit_two_state(qualities);
  fit.two_state_residuals = residuals_of(fit.two_state, qualities);
  const Residuals& first = fit.ar1_residuals;
  const Residuals& second = fit.two_state_residuals;
  if (first.sound && (!second.sound || first.bic <= second.bic)) {
    fit.model = fit.ar1;
  } else if (second.sound) {
    fit.model = fit.two_state;
  } else {
    BlockLink blocks{{}, block > 0 ? block : block_for(qualities)};
    for (const double x : qualities) {
      if (!std::isnan(x)) blocks.recording.push_back(x);
    }
    fit.model = blocks;
  }
  return fit;
}

LinkModel fit_like(const LinkModel& like, const std::vector<double>& qualities) {
  if (std::holds_alternative<Ar1Link>(like)) return fit_ar1(qualities);
  if (const auto* two = std::get_if<TwoStateLink>(&like)) return fit_two_state(qualities, *two);
  return BlockLink{qualities, std::get<BlockLink>(like).block};
}

}  // namespace tocsin::decision
