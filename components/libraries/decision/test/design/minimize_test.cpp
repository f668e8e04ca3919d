// SPDX-License-Identifier: Apache-2.0
#include "minimize.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tocsin::decision {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

TEST(Minimize, FindsTheBottomOfABentValley) {
  const auto rosenbrock = [](const std::vector<double>& x) {
    return 100 * std::pow(x[1] - x[0] * x[0], 2) + std::pow(1 - x[0], 2);
  };
  const Minimum sut = minimize(rosenbrock, {-1.2, 1});
  EXPECT_TRUE(sut.converged);
  EXPECT_THAT(sut.x, ElementsAre(DoubleNear(1, 1e-5), DoubleNear(1, 1e-5)));
  EXPECT_NEAR(sut.value, 0, 1e-12);
}

TEST(Minimize, StaysWhereTheFunctionIsFinite) {
  const auto beyond_two = [](const std::vector<double>& x) {
    return x[0] < 2 ? std::numeric_limits<double>::infinity() : x[0] * x[0];
  };
  const Minimum sut = minimize(beyond_two, {7});
  EXPECT_NEAR(sut.x[0], 2, 1e-6);
  EXPECT_GE(sut.x[0], 2);
}

TEST(Minimize, SaysWhenItDidNotEnd) {
  const auto long_valley = [](const std::vector<double>& x) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      sum += 100 * std::pow(x[i + 1] - x[i] * x[i], 2) + std::pow(1 - x[i], 2);
    }
    return sum;
  };
  EXPECT_FALSE(minimize(long_valley, std::vector<double>(30, -1.2)).converged);
}

}  // namespace
}  // namespace tocsin::decision
