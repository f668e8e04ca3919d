// SPDX-License-Identifier: Apache-2.0
#include "topic_choice.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin::bag_tool {
namespace {

struct Case {
  TopicWishes said;
  std::vector<const char*> contained;
  std::vector<const char*> left_out;
};

TEST(TopicChoice, IsWhatNamesExpressionsAndExclusionsSayTogether) {
  // {all, topics, regex, exclude_regex, exclude_topics, hidden}
  const std::vector<Case> cases{
      {{}, {"/odom"}, {"/_hidden", "/a/_hidden/b"}},
      {{false, {"odom", "/tf", "/_secret"}, "", "", {}, false},
       {"/odom", "/tf", "/_secret"},
       {"/uxv/odom", "/other"}},
      {{false, {}, "scan|^/uxv/.*odom$", "", {}, false},
       {"/laser_scan/raw", "/uxv/base/odom"},
       {"/gcs/odom"}},
      {{false, {"goal"}, "odom", "", {}, false}, {"/goal", "/odom"}, {"/battery"}},
      {{true, {}, "odom", "", {}, false}, {"/battery"}, {}},
      {{true, {}, "", "image", {"rosout"}, false},
       {"/odom"},
       {"/camera/image/compressed", "/rosout"}},
      {{false, {}, "", "", {}, true}, {"/_hidden"}, {}}};
  for (const auto& [said, contained, left_out] : cases) {
    const TopicChoice sut(said);
    for (const char* topic : contained) EXPECT_TRUE(sut.contains(topic)) << topic;
    for (const char* topic : left_out) EXPECT_FALSE(sut.contains(topic)) << topic;
  }
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
