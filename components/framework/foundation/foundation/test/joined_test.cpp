// SPDX-License-Identifier: Apache-2.0
#include "foundation/joined.hpp"

#include <gtest/gtest.h>

#include <map>

namespace tocsin {
namespace {

TEST(Joined, PutsATextBetween) {
  EXPECT_EQ(joined({}), "");
  EXPECT_EQ(joined({"one"}), "one");
  EXPECT_EQ(joined({"one", "two", "three"}), "one, two, three");
  EXPECT_EQ(joined({"one", "two"}, " or "), "one or two");
}

TEST(Joined, CountsEmptyTexts) { EXPECT_EQ(joined({"", "", "c"}), ", , c"); }

TEST(JoinedOf, AsksForTheTextOfEach) {
  const std::map<std::string, int> ages{{"a", 1}, {"b", 2}};
  const auto text = [](const auto& one) { return one.first + "=" + std::to_string(one.second); };
  EXPECT_EQ(joined_of(ages, text), "a=1, b=2");
  EXPECT_EQ(joined_of(ages, text, "; "), "a=1; b=2");
}

}  // namespace
}  // namespace tocsin
