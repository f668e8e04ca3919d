// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "decision/design/link_model.hpp"
#include "foundation/error.hpp"
#include "held_normal.hpp"

namespace tocsin::decision {
namespace {

using Pair = std::array<double, 2>;  // of the state high, of the state low

constexpr int most_rounds = 300;
constexpr double least_sd = 0.5;

Pair weights_of(double x, const TwoStateLink& link) {
  if (std::isnan(x)) return {1, 1};
  const double high = HeldNormal{link.high.mean, link.high.sd * link.high.sd}.log_density(x);
  const double low = HeldNormal{link.low.mean, link.low.sd * link.low.sd}.log_density(x);
  const double top = std::max(high, low);
  return {std::exp(high - top), std::exp(low - top)};
}

/// One round of Baum and Welch: probabilities of the states given all qualities, and from them the
/// next model.
class Round {
 public:
  Round(const std::vector<double>& x, const TwoStateLink& link) : x_(x), link_(link) {
    forward();
    backward();
  }
  [[nodiscard]] TwoStateLink next() const {
    const double n = static_cast<double>(x_.size());
    const double floor = 0.5 / n;
    return {law(0, link_.high), law(1, link_.low),
            std::clamp(moves_[0] / stays_[0], floor, 1 - floor),
            std::clamp(moves_[1] / stays_[1], floor, 1 - floor)};
  }

 private:
  [[nodiscard]] Pair step(const Pair& p) const {
    return {p[0] * (1 - link_.high_to_low) + p[1] * link_.low_to_high,
            p[0] * link_.high_to_low + p[1] * (1 - link_.low_to_high)};
  }

  void forward() {
    const double sum = link_.high_to_low + link_.low_to_high;
    Pair predicted{link_.low_to_high / sum, link_.high_to_low / sum};
    for (const double x : x_) {
      const Pair w = weights_of(x, link_);
      Pair p{predicted[0] * w[0], predicted[1] * w[1]};
      const double total = std::max(p[0] + p[1], 1e-300);
      p = {p[0] / total, p[1] / total};
      weights_.push_back(w);
      filtered_.push_back(p);
      predicted = step(p);
    }
  }

  void backward() {
    state_.resize(x_.size());
    Pair after{1, 1};  // likelihood of what comes later, up to a factor
    for (std::size_t i = x_.size(); i-- > 0;) {
      const Pair& p = filtered_[i];
      const double total = p[0] * after[0] + p[1] * after[1];
      state_[i] = {p[0] * after[0] / total, p[1] * after[1] / total};
      if (i == 0) break;
      const Pair ahead{weights_[i][0] * after[0], weights_[i][1] * after[1]};
      count_moves(filtered_[i - 1], ahead);
      after = {(1 - link_.high_to_low) * ahead[0] + link_.high_to_low * ahead[1],
               link_.low_to_high * ahead[0] + (1 - link_.low_to_high) * ahead[1]};
      const double scale = after[0] + after[1];
      after = {after[0] / scale, after[1] / scale};
    }
  }

  void count_moves(const Pair& from, const Pair& ahead) {
    const Pair stay{from[0] * (1 - link_.high_to_low) * ahead[0],
                    from[1] * (1 - link_.low_to_high) * ahead[1]};
    const Pair move{from[0] * link_.high_to_low * ahead[1], from[1] * link_.low_to_high * ahead[0]};
    const double total = stay[0] + stay[1] + move[0] + move[1];
    for (const std::size_t s : {0U, 1U}) {
      moves_[s] += move[s] / total;
      stays_[s] += (stay[s] + move[s]) / total;
    }
  }

  [[nodiscard]] Normal law(std::size_t s, const Normal& before) const {
    double weight = 1e-9;
    double sum = 0;
    double squares = 0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      if (std::isnan(x_[i])) continue;
      const HeldNormal meant = meant_by(x_[i], before);
      weight += state_[i][s];
      sum += state_[i][s] * (meant.mean - before.mean);
      squares +=
          state_[i][s] * ((meant.mean - before.mean) * (meant.mean - before.mean) + meant.variance);
    }
    const double shift = sum / weight;
    const double variance = squares / weight - shift * shift;
    return {before.mean + shift, std::sqrt(std::max(variance, least_sd * least_sd))};
  }

  const std::vector<double>& x_;
  TwoStateLink link_;
  std::vector<Pair> weights_;
  std::vector<Pair> filtered_;
  std::vector<Pair> state_;
  Pair moves_{};
  Pair stays_{1e-9, 1e-9};
};

double distance(const TwoStateLink& a, const TwoStateLink& b) {
  return std::max({std::abs(a.high.mean - b.high.mean), std::abs(a.low.mean - b.low.mean),
                   std::abs(a.high.sd - b.high.sd), std::abs(a.low.sd - b.low.sd),
                   10 * std::abs(a.high_to_low / b.high_to_low - 1),
                   10 * std::abs(a.low_to_high / b.low_to_high - 1)});
}

Normal law_of(const double* first, const double* last) {
  double mean = 0;
  double squares = 0;
  const double n = static_cast<double>(last - first);
  for (const double* x = first; x != last; ++x) mean += *x / n;
  for (const double* x = first; x != last; ++x) squares += (*x - mean) * (*x - mean) / n;
  return {mean, std::max(std::sqrt(squares), least_sd)};
}

}  // namespace

TwoStateLink fit_two_state(const std::vector<double>& qualities, const TwoStateLink& start) {
  TwoStateLink link = start;
  for (int i = 0; i < most_rounds; ++i) {
    const TwoStateLink next = Round(qualities, link).next();
    const double moved = distance(next, link);
    link = next;
    if (moved < 1e-3) break;
  }
  if (link.high.mean >= link.low.mean) return link;
  return {link.low, link.high, link.low_to_high, link.high_to_low};
}

TwoStateLink fit_two_state(const std::vector<double>& qualities) {
  std::vector<double> sorted;
  for (const double x : qualities) {
    if (!std::isnan(x)) sorted.push_back(x);
  }
  if (sorted.size() < 50) {
    throw ConfigError("recording: " + std::to_string(sorted.size()) +
                      " qualities, at least 50 are needed");
  }
  std::sort(sorted.begin(), sorted.end());
  const double* first = sorted.data();
  const double* last = first + sorted.size();
  const double* quarter = first + sorted.size() / 4;
  return fit_two_state(qualities, {law_of(quarter, last), law_of(first, quarter), 0.02, 0.05});
}

}  // namespace tocsin::decision
