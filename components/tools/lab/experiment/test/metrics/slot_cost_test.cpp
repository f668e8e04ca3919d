// SPDX-License-Identifier: Apache-2.0
#include "metrics/slot_cost.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tocsin::experiment {
namespace {

/// Ten slots; those from 4 to 6 are bad, the gate is closed in those from `from` to `to`.
std::vector<Observation> ten(int from, int to) {
  std::vector<Observation> series(10);
  for (int i = 0; i < 10; ++i) {
    auto& one = series[static_cast<std::size_t>(i)];
    one.poor = i >= 4 && i <= 6 ? 1 : 0;
    one.active = i >= from && i <= to ? 0 : 1;
  }
  return series;
}

TEST(SlotCost, OfSpeakingAlwaysIsOnePerBadSlot) {
  EXPECT_NEAR(slot_cost(ten(20, 0)).own, 100 * 3, 1e-9);
}

TEST(SlotCost, OfSilenceWhereItBelongsIsTheClairvoyants) {
  const SlotCost sut = slot_cost(ten(4, 6));
  EXPECT_NEAR(sut.own, 100 * (3 * 0.1 + 2 * 0.5), 1e-9);
  EXPECT_NEAR(sut.clairvoyant, sut.own, 1e-9);
}

TEST(SlotCost, CountsSilenceInGoodSlots) {
  const SlotCost sut = slot_cost(ten(4, 8));
  EXPECT_NEAR(sut.own - sut.clairvoyant, 100 * 2 * 0.5, 1e-9);
}

TEST(SlotCost, TakesASlotForBadOnlyWhenMoreThanHalfOfItIs) {
  auto series = ten(20, 0);
  for (auto& one : series) one.poor *= 0.5;
  EXPECT_EQ(slot_cost(series).own, 0);
  series[4].poor = 0.51;
  EXPECT_NEAR(slot_cost(series).own, 100, 1e-9);
}

TEST(SlotCost, TakesASlotForSpokenInWhenTheGateWasOpenForHalfOfIt) {
  auto series = ten(20, 0);
  series[1].active = 0.5;
  EXPECT_NEAR(slot_cost(series).own, 300, 1e-9);
  series[1].active = 0.49;
  EXPECT_NEAR(slot_cost(series).own, 300 + 100 * (0.5 + 2 * 0.5), 1e-9);
}

TEST(SlotCost, IsNoneWithoutObservations) { EXPECT_TRUE(std::isnan(slot_cost({}).own)); }

}  // namespace
}  // namespace tocsin::experiment
