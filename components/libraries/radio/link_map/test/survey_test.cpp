// SPDX-License-Identifier: Apache-2.0
#include "link_map/survey.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tocsin::link_map {
namespace {

TEST(Survey, TakesNoReadingsThatAreNone) {
  Survey sut;
  EXPECT_FALSE(sut.add({{0, 0}, std::nan("")}));
  EXPECT_FALSE(sut.add({{std::nan(""), 0}, -50}));
  EXPECT_FALSE(sut.add({{0, 1e9}, -50}));
  EXPECT_FALSE(sut.add({{0, 0}, 1}));
  EXPECT_FALSE(sut.add({{0, 0}, -121}));
  EXPECT_EQ(sut.size(), 0U);
  EXPECT_TRUE(sut.add({{0, 0}, -120}));
}

TEST(Survey, TheNewestReadingsOfAPlaceCount) {
  Survey sut;
  for (int i = 0; i < 100; ++i) (void)sut.add({{0.1, 0.1}, -80});
  for (int i = 0; i < 64; ++i) (void)sut.add({{0.1, 0.1}, -50});
  ASSERT_EQ(sut.places().size(), 1U);
  EXPECT_DOUBLE_EQ(sut.places()[0].signal_dbm, -50);
  EXPECT_EQ(sut.places()[0].readings, 164);
}

TEST(Survey, ReadingsThatAreKeptMakeTheSameSurvey) {
  Survey sut;
  for (int i = 0; i < 400; ++i) {
    (void)sut.add({{0.07 * (i % 40), 0.1 * (i % 3)}, -40.0 - i % 17});
  }
  for (int i = 0; i < 70; ++i) (void)sut.add({{0.01, 0.01}, -60.0 - i % 5});
  Survey again;
  for (const Reading& reading : sut.readings()) EXPECT_TRUE(again.add(reading));
  const auto before = sut.places();
  const auto after = again.places();
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_DOUBLE_EQ(after[i].signal_dbm, before[i].signal_dbm);
    EXPECT_NEAR(distance(after[i].at, before[i].at), 0, 0.2);
  }
  for (int i = 0; i < 60; ++i) {  // also which is the oldest
    (void)sut.add({{0.01, 0.01}, -30});
    (void)again.add({{0.01, 0.01}, -30});
  }
  EXPECT_DOUBLE_EQ(again.places()[0].signal_dbm, sut.places()[0].signal_dbm);
}

}  // namespace
}  // namespace tocsin::link_map
