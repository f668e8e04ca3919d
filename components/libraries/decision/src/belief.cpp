// SPDX-License-Identifier: Apache-2.0
#include "decision/belief.hpp"

#include <sstream>

#include "foundation/error.hpp"

namespace tocsin::decision {
namespace {

constexpr std::size_t grid_size = 201;
constexpr double discount = 0.999;

void check(const TwoStateChannel& channel) {
  for (const double p : {channel.good_to_bad, channel.bad_to_good}) {
    if (p > 0 && p < 1) continue;
    std::ostringstream text;
    text << "belief: probability of a change " << p << " is outside (0, 1)";
    throw ConfigError(text.str());
  }
}

double predict(const TwoStateChannel& channel, double posterior) {
  return posterior * (1 - channel.bad_to_good) + (1 - posterior) * channel.good_to_bad;
}

/// Bayes's rule; `l` may be infinite.
double update(double prior, double l) {
  if (prior <= 0 || prior >= 1) return prior;
  const double odds = std::log(prior / (1 - prior)) + l;
  return odds > 0 ? 1 / (1 + std::exp(-odds)) : std::exp(odds) / (1 + std::exp(odds));
}

double belief_at(std::size_t i) { return static_cast<double>(i) / (grid_size - 1); }

/// A quality with its probability under each law and the ratio that it shows.
struct Node {
  double good;
  double bad;
  double llr;
};

std::vector<Node> nodes_of(const Density& good, const Density& bad) {
  std::vector<Node> nodes;
  double good_sum = 0;
  double bad_sum = 0;
  for (double x = -100.5; x < 200; x += 1) {
    const Node node{good.cdf(x + 0.5) - good.cdf(x - 0.5), bad.cdf(x + 0.5) - bad.cdf(x - 0.5), 0};
    if (node.good + node.bad < 1e-9) continue;
    nodes.push_back(node);
    good_sum += node.good;
    bad_sum += node.bad;
  }
  for (Node& node : nodes) {
    node.good /= good_sum;
    node.bad /= bad_sum;
    node.llr = std::log(std::max(node.bad, 1e-22) / std::max(node.good, 1e-22));
  }
  return nodes;
}

using Values = std::vector<double>;  // by belief

/// E[V(next belief)] as a sparse matrix on the grid of beliefs.
class Expectation {
 public:
  Expectation(const TwoStateChannel& channel, const std::vector<Node>& nodes) : rows_(grid_size) {
    for (std::size_t i = 0; i < grid_size; ++i) {
      const double prior = belief_at(i);
      Values dense(grid_size, 0.0);
      for (const Node& node : nodes) {
        const double weight = prior * node.bad + (1 - prior) * node.good;
        spread(dense, predict(channel, update(prior, node.llr)), weight);
      }
      for (std::size_t j = 0; j < grid_size; ++j) {
        if (dense[j] > 0) rows_[i].push_back({j, dense[j]});
      }
    }
  }
  [[nodiscard]] Values of(const Values& v) const {
    Values out(grid_size, 0.0);
    for (std::size_t i = 0; i < grid_size; ++i) {
      for (const Entry& entry : rows_[i]) out[i] += entry.weight * v[entry.column];
    }
    return out;
  }

 private:
  struct Entry {
    std::size_t column;
    double weight;
  };
  static void spread(Values& row, double belief, double weight) {
    const double at = belief * (grid_size - 1);
    const auto low = std::min(static_cast<std::size_t>(at), grid_size - 2);
    const double share = at - static_cast<double>(low);
    row[low] += weight * (1 - share);
    row[low + 1] += weight * share;
  }
  std::vector<std::vector<Entry>> rows_;
};

class ValueIteration {
 public:
  ValueIteration(const Expectation& expectation, const SlotCosts& costs, int th_max)
      : expectation_(expectation),
        costs_(costs),
        ages_(static_cast<std::size_t>(th_max) + 1),
        value_(ages_, Values(grid_size, 0.0)),
        next_(ages_) {}

  /// One sweep; returns the spread of the change, which is what moves the thresholds.
  double sweep() {
    for (std::size_t age = 0; age < ages_; ++age) next_[age] = expectation_.of(value_[age]);
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t age = 0; age < ages_; ++age) {
      for (std::size_t i = 0; i < grid_size; ++i) {
        const double v = std::min(speak(age, i), stay_silent(age, i));
        least = std::min(least, v - value_[age][i]);
        most = std::max(most, v - value_[age][i]);
        value_[age][i] = v;
      }
    }
    return most - least;
  }

  /// The belief from which silence is better, after the last sweep; above 1 when there is none.
  [[nodiscard]] double threshold(std::size_t age) const {
    const auto gain = [&](std::size_t i) { return speak(age, i) - stay_silent(age, i); };
    std::size_t i = grid_size - 1;
    if (!(gain(i) >= 0)) return 2;
    while (i > 0 && gain(i - 1) >= 0) --i;
    if (i == 0) return 0;
    const double share = gain(i) / (gain(i) - gain(i - 1));
    return belief_at(i) - share * (belief_at(i) - belief_at(i - 1));
  }

 private:
  [[nodiscard]] double speak(std::size_t age, std::size_t i) const {
    return belief_at(i) * costs_.send_bad + (age > 0 ? costs_.change : 0) + discount * next_[0][i];
  }
  [[nodiscard]] double stay_silent(std::size_t age, std::size_t i) const {
    if (age + 1 == ages_) return std::numeric_limits<double>::infinity();
    const double slot = belief_at(i) * costs_.silent_bad + (1 - belief_at(i)) * costs_.silent_good;
    return slot + (age == 0 ? costs_.change : 0) + discount * next_[age + 1][i];
  }

  const Expectation& expectation_;
  SlotCosts costs_;
  std::size_t ages_;
  std::vector<Values> value_;
  std::vector<Values> next_;
};

}  // namespace

BeliefFilter::BeliefFilter(const TwoStateChannel& channel)
    : channel_(channel), predicted_(channel.good_to_bad) {
  check(channel);
}

double BeliefFilter::add(double l) {
  posterior_ = std::isnan(l) ? predicted_ : update(predicted_, l);
  predicted_ = predict(channel_, posterior_);
  return predicted_;
}

void BeliefFilter::forget() {
  predicted_ = channel_.good_to_bad / (channel_.good_to_bad + channel_.bad_to_good);
  posterior_ = predicted_;
}

BeliefThresholds solve_belief(const TwoStateChannel& channel, const SlotCosts& costs,
                              const Density& good, const Density& bad, int th_max_samples) {
  check(channel);
  const Expectation expectation(channel, nodes_of(good, bad));
  ValueIteration iteration(expectation, costs, th_max_samples);
  BeliefThresholds result{{}, 1};
  while (iteration.sweep() > 1e-7 && result.iterations < 5000) ++result.iterations;
  for (int age = 0; age <= th_max_samples; ++age) {
    result.threshold.push_back(iteration.threshold(static_cast<std::size_t>(age)));
  }
  return result;
}

BeliefThresholds myopic_belief(const SlotCosts& costs, int th_max_samples) {
  const double threshold =
      costs.silent_good / (costs.send_bad + costs.silent_good - costs.silent_bad);
  return {std::vector<double>(static_cast<std::size_t>(th_max_samples) + 1, threshold), 0};
}

}  // namespace tocsin::decision
