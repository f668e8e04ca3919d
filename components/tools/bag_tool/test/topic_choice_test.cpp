// SPDX-License-Identifier: Apache-2.0
#include "topic_choice.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin::bag_tool {
namespace {

TopicWishes wishes() { return {}; }

TEST(TopicChoice, IsAllWhenNothingIsSaid) {
  const TopicChoice sut(wishes());
  EXPECT_TRUE(sut.contains("/odom"));
  EXPECT_FALSE(sut.contains("/_hidden"));
  EXPECT_FALSE(sut.contains("/a/_hidden/b"));
}

TEST(TopicChoice, IsTheNamesThatAreSaidWithOrWithoutASlash) {
  TopicWishes said;
  said.topics = {"odom", "/tf", "/_secret"};
  const TopicChoice sut(said);
  EXPECT_TRUE(sut.contains("/odom"));
  EXPECT_TRUE(sut.contains("/tf"));
  EXPECT_TRUE(sut.contains("/_secret")) << "asked for by its name";
  EXPECT_FALSE(sut.contains("/uxv/odom"));
  EXPECT_FALSE(sut.contains("/other"));
}

TEST(TopicChoice, IsTopicsThatContainAMatchOfTheExpression) {
  TopicWishes said;
  said.regex = "scan|^/uxv/.*odom$";
  const TopicChoice sut(said);
  EXPECT_TRUE(sut.contains("/laser_scan/raw"));
  EXPECT_TRUE(sut.contains("/uxv/base/odom"));
  EXPECT_FALSE(sut.contains("/gcs/odom"));
}

TEST(TopicChoice, NamesAndExpressionAddUp) {
  TopicWishes said;
  said.topics = {"goal"};
  said.regex = "odom";
  const TopicChoice sut(said);
  EXPECT_TRUE(sut.contains("/goal"));
  EXPECT_TRUE(sut.contains("/odom"));
  EXPECT_FALSE(sut.contains("/battery"));
}

TEST(TopicChoice, AllOverridesTheExpression) {
  TopicWishes said;
  said.all = true;
  said.regex = "odom";
  EXPECT_TRUE(TopicChoice(said).contains("/battery"));
}

TEST(TopicChoice, LeavesOutWhatIsExcluded) {
  TopicWishes said;
  said.all = true;
  said.exclude_regex = "image";
  said.exclude_topics = {"rosout"};
  const TopicChoice sut(said);
  EXPECT_TRUE(sut.contains("/odom"));
  EXPECT_FALSE(sut.contains("/camera/image/compressed"));
  EXPECT_FALSE(sut.contains("/rosout"));
}

TEST(TopicChoice, ShowsHiddenTopicsWhenAsked) {
  TopicWishes said;
  said.hidden = true;
  EXPECT_TRUE(TopicChoice(said).contains("/_hidden"));
}

TEST(TopicChoice, RefusesWhatIsNoExpression) {
  for (const std::string text : {"(", "[a", "*", "a)"}) {
    TopicWishes said;
    said.regex = text;
    EXPECT_THROW(TopicChoice{said}, ConfigError) << text;
    said.regex = "";
    said.exclude_regex = text;
    EXPECT_THROW(TopicChoice{said}, ConfigError) << text;
  }
}

TEST(TopicChoice, GivesUpOnAnExpressionThatTakesTooLong) {
  TopicWishes said;
  said.regex = "^(/?a+)+(/?a+)+(/?a+)+$";
  const TopicChoice sut(said);
  EXPECT_THROW((void)sut.contains("/" + std::string(3000, 'a') + "!"), ConfigError);
}

}  // namespace
}  // namespace tocsin::bag_tool
