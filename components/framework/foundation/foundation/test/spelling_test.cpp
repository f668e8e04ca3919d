// SPDX-License-Identifier: Apache-2.0
#include "foundation/spelling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::vector<std::string> verbs{"launch", "topic", "report"};

TEST(Spelling, SuggestsLongWordsThatDifferByAtMostTwoLetters) {
  EXPECT_THAT(similar(verbs, "lanch"), ElementsAre("launch"));
  EXPECT_THAT(similar(verbs, "lanuch"), ElementsAre("launch"));
  EXPECT_THAT(similar(verbs, "lunc"), ElementsAre("launch"));
  EXPECT_THAT(similar(verbs, "lau"), IsEmpty());
}

TEST(Spelling, SuggestsNoWordOfTwoLetters) { EXPECT_THAT(similar({"x", "no"}, "z"), IsEmpty()); }

TEST(Spelling, SuggestsShortWordsThatDifferByOneLetter) {
  EXPECT_THAT(similar({"near", "far"}, "neer"), ElementsAre("near"));
  EXPECT_THAT(similar({"near"}, "far"), IsEmpty());
}

TEST(Spelling, TwoLettersThatChangedPlacesAreOneDifference) {
  EXPECT_THAT(similar({"odom"}, "odmo"), ElementsAre("odom"));
  EXPECT_THAT(similar({"navigator"}, "anvigatro"), ElementsAre("navigator"));
}

TEST(Spelling, ASuggestionIsNothingWithoutASimilarWord) {
  EXPECT_EQ(suggestion(verbs, "tpic"), "; did you mean 'topic'?");
  EXPECT_EQ(suggestion(verbs, "xyz"), "");
  EXPECT_EQ(suggestion({}, "xyz"), "");
}

TEST(Spelling, ASimilarWordIsAskedFor) {
  EXPECT_EQ(did_you_mean(verbs, "lanch", "the verbs are"), "; did you mean 'launch'?");
  EXPECT_EQ(did_you_mean({"read", "road"}, "rad", "there are"), "; did you mean 'read' or 'road'?");
}

TEST(Spelling, WithoutASimilarWordAllAreListed) {
  EXPECT_EQ(did_you_mean(verbs, "xyz", "the verbs are"), "; the verbs are: launch, topic, report");
}

}  // namespace
}  // namespace tocsin
