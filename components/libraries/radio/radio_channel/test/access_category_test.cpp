// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/access_category.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace tocsin::radio {
namespace {

TEST(AccessCategory, TheClassSelectorsOfOurClassesAreTheFourCategories) {
  EXPECT_EQ(access_category_of_dscp(48), AccessCategory::voice);
  EXPECT_EQ(access_category_of_dscp(32), AccessCategory::video);
  EXPECT_EQ(access_category_of_dscp(0), AccessCategory::best_effort);
  EXPECT_EQ(access_category_of_dscp(8), AccessCategory::background);
}

TEST(AccessCategory, FollowsRfc8325WhereTheUpperThreeBitsWouldSayOtherwise) {
  for (const int dscp : {10, 12, 14, 16, 18, 20, 22}) {  // AF1x, CS2, AF2x
    EXPECT_EQ(access_category_of_dscp(static_cast<std::uint8_t>(dscp)), AccessCategory::best_effort)
        << dscp;
  }
  for (const int dscp : {24, 26, 28, 30}) {  // CS3, AF3x
    EXPECT_EQ(access_category_of_dscp(static_cast<std::uint8_t>(dscp)), AccessCategory::video)
        << dscp;
  }
  for (const int dscp : {44, 46}) {  // voice admit, EF
    EXPECT_EQ(access_category_of_dscp(static_cast<std::uint8_t>(dscp)), AccessCategory::voice)
        << dscp;
  }
}

TEST(AccessCategory, FollowsTheUpperThreeBitsElsewhere) {
  const std::pair<int, AccessCategory> known[] = {
      {1, AccessCategory::best_effort}, {9, AccessCategory::background},
      {17, AccessCategory::background}, {25, AccessCategory::best_effort},
      {34, AccessCategory::video},      {40, AccessCategory::video},
      {56, AccessCategory::voice},      {63, AccessCategory::voice}};
  for (const auto& [dscp, category] : known) {
    EXPECT_EQ(access_category_of_dscp(static_cast<std::uint8_t>(dscp)), category) << dscp;
  }
}

TEST(AccessCategory, HasTheRulesOf80211ForOfdm) {
  const AccessRules voice = access_rules(AccessCategory::voice);
  const AccessRules background = access_rules(AccessCategory::background);
  EXPECT_EQ(voice.aifsn, 2);
  EXPECT_EQ(voice.cw_min, 3);
  EXPECT_EQ(voice.cw_max, 7);
  EXPECT_EQ(access_rules(AccessCategory::video).cw_max, 15);
  EXPECT_EQ(access_rules(AccessCategory::best_effort).aifsn, 3);
  EXPECT_EQ(background.aifsn, 7);
  EXPECT_EQ(background.cw_max, 1023);
}

TEST(AccessCategory, HasAName) {
  std::string names;
  for (const AccessCategory one : access_categories) names += std::string(to_string(one)) + " ";
  EXPECT_EQ(names, "voice video best_effort background ");
}

}  // namespace
}  // namespace tocsin::radio
