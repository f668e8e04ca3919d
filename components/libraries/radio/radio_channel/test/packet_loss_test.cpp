// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/packet_loss.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tocsin::radio {
namespace {

constexpr Time t0{};

ChannelParams bernoulli(double loss) {
  ChannelParams params;
  params.mode = "bernoulli";
  params.loss = loss;
  return params;
}

ChannelParams gilbert_elliott() {
  ChannelParams params;
  params.mode = "gilbert_elliott";
  params.good_s = 4;
  params.bad_s = 1;
  params.good_loss = 0;
  params.bad_loss = 1;
  return params;
}

std::vector<bool> losses(const ChannelParams& params, std::uint64_t seed, int count,
                         double step_s) {
  PacketLoss sut(params, seed, t0);
  std::vector<bool> result;
  for (int i = 0; i < count; ++i) result.push_back(sut.lost(t0 + seconds(i * step_s)));
  return result;
}

double share(const std::vector<bool>& lost) {
  int count = 0;
  for (const bool one : lost) count += one ? 1 : 0;
  return count / static_cast<double>(lost.size());
}

TEST(Bernoulli, LosesItsShareByChiSquare) {
  for (const double p : {0.02, 0.10, 0.25}) {
    constexpr int n = 200000;
    const double difference = n * (share(losses(bernoulli(p), 11, n, 0.01)) - p);
    EXPECT_LT(difference * difference / (n * p * (1 - p)), 10.83) << p;  // chi2(1), 0.1 %
  }
}

TEST(Bernoulli, IsIndependentByChiSquareOfPairs) {
  constexpr int n = 200000;
  const auto lost = losses(bernoulli(0.1), 12, n, 0.01);
  double counts[2][2] = {};
  for (int i = 0; i + 1 < n; i += 2) {
    const auto at = static_cast<std::size_t>(i);
    counts[lost[at] ? 1 : 0][lost[at + 1] ? 1 : 0] += 1;
  }
  const double p = share(lost);
  double chi_square = 0;
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 2; ++b) {
      const double expected = n / 2.0 * (a == 1 ? p : 1 - p) * (b == 1 ? p : 1 - p);
      chi_square += std::pow(counts[a][b] - expected, 2) / expected;
    }
  }
  EXPECT_LT(chi_square, 13.82);  // chi2(2), 0.1 %
}

TEST(Bernoulli, LosesNothingAtZeroAndAllAtOne) {
  EXPECT_EQ(share(losses(bernoulli(0), 1, 1000, 1)), 0);
  EXPECT_EQ(share(losses(bernoulli(1), 1, 1000, 1)), 1);
}

TEST(GilbertElliott, IsBadForItsShareOfTime) {
  EXPECT_NEAR(share(losses(gilbert_elliott(), 13, 1000000, 0.1)), 0.2, 0.006);
}

TEST(GilbertElliott, StaysBadForItsMeanTime) {
  const auto lost = losses(gilbert_elliott(), 14, 1000000, 0.02);
  int runs = 0;
  for (std::size_t i = 1; i < lost.size(); ++i) runs += lost[i] && !lost[i - 1] ? 1 : 0;
  EXPECT_NEAR(share(lost) * 1000000 * 0.02 / runs, 1.0, 0.08);
}

TEST(GilbertElliott, HasACourseThatDoesNotDependOnTheTraffic) {
  const auto dense = losses(gilbert_elliott(), 15, 100000, 0.01);
  const auto sparse = losses(gilbert_elliott(), 15, 1000, 1.0);
  for (std::size_t i = 0; i < sparse.size(); ++i) EXPECT_EQ(sparse[i], dense[i * 100]);
}

TEST(GilbertElliott, StartsInEitherState) {
  int bad = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    bad += losses(gilbert_elliott(), seed, 1, 1)[0] ? 1 : 0;
  }
  EXPECT_NEAR(bad, 200, 50);
}

}  // namespace
}  // namespace tocsin::radio
