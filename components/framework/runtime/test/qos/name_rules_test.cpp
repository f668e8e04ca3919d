// SPDX-License-Identifier: Apache-2.0
#include "runtime/detail/name_rules.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

TEST(NameRules, APatternStandsForAnyTextSlashesIncluded) {
  EXPECT_TRUE(fits("*/set_parameters", "arm/left/set_parameters"));
  EXPECT_FALSE(fits("*/set_parameters", "set_parameters"));
  EXPECT_TRUE(fits("leg?", "leg1"));
  EXPECT_FALSE(fits("leg?", "leg12"));
  EXPECT_TRUE(is_pattern("a[bc]"));
  EXPECT_FALSE(is_pattern("arm/left"));
}

TEST(NameRules, TheNameThenTheLongestPatternCounts) {
  NameRules<int> sut;
  EXPECT_TRUE(sut.add("*", 1));
  EXPECT_TRUE(sut.add("arm/*", 2));
  EXPECT_TRUE(sut.add("arm/left", 3));
  EXPECT_EQ(*sut.find("leg"), 1);
  EXPECT_EQ(*sut.find("arm/right"), 2);
  EXPECT_EQ(*sut.find("arm/left"), 3);
}

TEST(NameRules, WhatNothingFitsHasNoRule) {
  NameRules<int> sut;
  EXPECT_TRUE(sut.add("arm/*", 1));
  EXPECT_EQ(sut.find("leg"), nullptr);
}

TEST(NameRules, ANameOrPatternIsAddedOnce) {
  NameRules<int> sut;
  EXPECT_TRUE(sut.add("arm", 1));
  EXPECT_FALSE(sut.add("arm", 2));
  EXPECT_TRUE(sut.add("a*", 1));
  EXPECT_FALSE(sut.add("a*", 2));
  EXPECT_EQ(*sut.find("arm"), 1);
  EXPECT_EQ(*sut.find("axe"), 1);
}

}  // namespace
}  // namespace tocsin
