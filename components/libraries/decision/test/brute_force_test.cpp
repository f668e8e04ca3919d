// SPDX-License-Identifier: Apache-2.0
// Recursions against what they stand for: sums over all change times, all paths of the network's
// state, all orders of the candidates.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "decision/belief.hpp"
#include "decision/cusum.hpp"
#include "decision/stopping.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::decision {
namespace {

std::vector<double> random_ratios(unsigned seed, int count) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> law(-0.2, 1.5);
  std::vector<double> ratios;
  for (int i = 0; i < count; ++i) ratios.push_back(random() % 9 == 0 ? nan : law(random));
  return ratios;
}

std::vector<double> measured(const std::vector<double>& ratios) {
  std::vector<double> known;
  std::copy_if(ratios.begin(), ratios.end(), std::back_inserter(known),
               [](double l) { return !std::isnan(l); });
  return known;
}

TEST(CusumBySums, IsTheLargestSumOverAllChangeTimesAndItsLength) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::vector<double> ratios = random_ratios(seed, 60);
    Cusum sut;
    for (std::size_t n = 0; n < ratios.size(); ++n) {
      sut.add(ratios[n]);
      const auto known = measured({ratios.begin(), ratios.begin() + static_cast<long>(n) + 1});
      double largest = 0;
      std::size_t length = 0;
      double sum = 0;
      for (std::size_t back = 1; back <= known.size(); ++back) {
        sum += known[known.size() - back];
        if (sum <= largest) continue;
        largest = sum;
        length = back;
      }
      ASSERT_NEAR(sut.statistic(), largest, 1e-9);
      ASSERT_EQ(sut.run(), length);
    }
  }
}

/// P(bad in the slot after the last sample), over all 2^n paths of the state from "just good".
double predicted_over_paths(const TwoStateChannel& channel, const std::vector<double>& ratios) {
  double all = 0;
  double bad_next = 0;
  for (unsigned path = 0; path < 1U << ratios.size(); ++path) {
    double weight = 1;
    bool bad = false;
    for (std::size_t k = 0; k < ratios.size(); ++k) {
      const bool next = (path >> k & 1U) != 0;
      const double change = bad ? channel.bad_to_good : channel.good_to_bad;
      weight *= next != bad ? change : 1 - change;
      if (next && !std::isnan(ratios[k])) weight *= std::exp(ratios[k]);
      bad = next;
    }
    all += weight;
    bad_next += weight * (bad ? 1 - channel.bad_to_good : channel.good_to_bad);
  }
  return bad_next / all;
}

TEST(BeliefByPaths, IsTheShareOfThePathsThatEndInABadSlot) {
  std::mt19937_64 random(1);  // NOLINT: a fixed seed is the point
  std::uniform_real_distribution<double> probability(0.01, 0.99);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const TwoStateChannel channel{probability(random), probability(random)};
    const std::vector<double> ratios = random_ratios(seed, 10);
    BeliefFilter sut(channel);
    for (const double l : ratios) sut.add(l);
    EXPECT_NEAR(sut.predicted(), predicted_over_paths(channel, ratios), 1e-9) << "seed " << seed;
  }
}

/// What stopping by threshold `r` gives over all orders of `n` candidates.
SecretaryRule over_all_orders(int n, int r, const Discount& discount) {
  std::vector<int> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 1);  // n is the best
  SecretaryRule mean{r, 0, 0, 0, 0};
  double orders = 0;
  do {
    ++orders;
    int best = 0;
    int stop = 0;
    for (int k = 1; k <= n && stop == 0; ++k) {
      const int candidate = order[static_cast<std::size_t>(k) - 1];
      if (k >= r && candidate > best) stop = k;
      best = std::max(best, candidate);
    }
    mean.expected_stop += stop > 0 ? stop : n;
    mean.p_stopped += stop > 0;
    if (stop == 0 || order[static_cast<std::size_t>(stop) - 1] != n) continue;
    ++mean.p_best;
    mean.value += discount(stop);
  } while (std::next_permutation(order.begin(), order.end()));
  for (double* sum : {&mean.value, &mean.p_best, &mean.p_stopped, &mean.expected_stop}) {
    *sum /= orders;
  }
  return mean;
}

TEST(SecretaryByOrders, EveryThresholdIsWorthWhatAllOrdersGive) {
  for (const int n : {1, 2, 3, 5, 7}) {
    for (const Discount& discount : {geometric_discount(0.8), linear_discount(0.6, n)}) {
      double most = 0;
      for (int r = 1; r <= n; ++r) {
        SCOPED_TRACE(std::to_string(r) + " of " + std::to_string(n));
        const SecretaryRule sut = secretary_with_threshold(n, r, discount);
        const SecretaryRule wanted = over_all_orders(n, r, discount);
        EXPECT_NEAR(sut.value, wanted.value, 1e-12);
        EXPECT_NEAR(sut.p_best, wanted.p_best, 1e-12);
        EXPECT_NEAR(sut.p_stopped, wanted.p_stopped, 1e-12);
        EXPECT_NEAR(sut.expected_stop, wanted.expected_stop, 1e-12);
        most = std::max(most, wanted.value);
      }
      EXPECT_NEAR(discounted_secretary(n, discount).value, most, 1e-12) << n;
    }
  }
}

}  // namespace
}  // namespace tocsin::decision
