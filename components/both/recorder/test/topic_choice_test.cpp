// SPDX-License-Identifier: Apache-2.0
#include "recorder/topic_choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "ros_idl/sensor_msgs.hpp"
#include "ros_idl/std_msgs.hpp"

namespace tocsin {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const TypeInfo& text_type = type_info<std_msgs::msg::String>();
const TypeInfo& imu_type = type_info<sensor_msgs::msg::Imu>();

const std::vector<KnownTopic> known{{{"odom", "sensor", Scope::host}, &imu_type},
                                    {{"goal", "command", Scope::link}, &text_type},
                                    {{"sensors/imu", "sensor", Scope::host}, &imu_type},
                                    {{"sensors/dock/ir", "event", Scope::host}, &text_type},
                                    {{"location", "telemetry", Scope::link}, &text_type}};

std::vector<ChosenTopic> choose(const std::vector<std::string>& topics, bool link_topics = false) {
  return choose_topics("recorder", {link_topics, topics}, known);
}

std::vector<std::string> names(const std::vector<ChosenTopic>& topics) {
  std::vector<std::string> all;
  for (const ChosenTopic& topic : topics) all.emplace_back(topic.info.name);
  return all;
}

std::string error_of(const std::string& wish) {
  try {
    (void)choose({wish});
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(TopicChoice, TakesTheTopicsOfTheLinkUnlessToldOtherwise) {
  EXPECT_THAT(names(choose({}, true)), ElementsAre("goal", "location"));
  EXPECT_THAT(choose({}), IsEmpty());
}

TEST(TopicChoice, NeedsNoOtherLibraryForKnownTopicsAndTypes) {
  EXPECT_TRUE(are_stated({}, known));
  EXPECT_TRUE(are_stated({"odom", "/goal", "scan sensor_msgs/msg/Imu"}, known));
  EXPECT_FALSE(are_stated({"odom", "lidar"}, known));
  EXPECT_FALSE(are_stated({"sensors/*"}, known));
  EXPECT_FALSE(are_stated({"scan no_msgs/msg/Type"}, known));
  EXPECT_FALSE(are_stated({""}, known));
}

TEST(TopicChoice, AKnownNameIsTakenWithItsFacts) {
  const auto sut = choose({"/odom"}, true);
  EXPECT_THAT(names(sut), ElementsAre("goal", "location", "odom"));
  EXPECT_EQ(sut[2].type, &imu_type);
  EXPECT_STREQ(sut[2].info.qos, "sensor");
  EXPECT_EQ(sut[2].info.scope, Scope::host);
  EXPECT_TRUE(sut[2].named);
  EXPECT_FALSE(sut[0].named);
}

TEST(TopicChoice, APatternTakesAllThatMatch) {
  EXPECT_THAT(names(choose({"sensors/*"})), ElementsAre("sensors/imu", "sensors/dock/ir"));
  EXPECT_THAT(names(choose({"*o*"})),
              ElementsAre("odom", "goal", "sensors/imu", "sensors/dock/ir", "location"));
  EXPECT_FALSE(choose({"odo?"})[0].named) << "nobody need write what a pattern finds";
}

TEST(TopicChoice, TakesEachTopicOnceAndItsNameCounts) {
  const auto sut = choose({"*", "goal", "goal"}, true);
  EXPECT_EQ(sut.size(), known.size());
  EXPECT_STREQ(sut[0].info.name, "goal");
  EXPECT_TRUE(sut[0].named);
}

TEST(TopicChoice, AnyOtherTopicIsDescribedByItsType) {
  const auto sut = choose({"scan sensor_msgs/msg/Imu", "map std_msgs/msg/String state link"});
  EXPECT_THAT(names(sut), ElementsAre("scan", "map"));
  EXPECT_EQ(sut[0].type, &imu_type);
  EXPECT_STREQ(sut[0].info.qos, "sensor") << "asks for nothing that a writer might not offer";
  EXPECT_EQ(sut[0].info.scope, Scope::host);
  EXPECT_STREQ(sut[1].info.qos, "state");
  EXPECT_EQ(sut[1].info.scope, Scope::link);
}

TEST(TopicChoice, AKnownTopicKeepsItsFactsUnlessTheyAreSaid) {
  EXPECT_STREQ(choose({"goal std_msgs/msg/String"})[0].info.qos, "command");
  EXPECT_EQ(choose({"goal std_msgs/msg/String"})[0].info.scope, Scope::link);
  EXPECT_STREQ(choose({"goal std_msgs/msg/String event link"}, true)[0].info.qos, "event");
}

TEST(TopicChoice, RefusesAnUnknownNameWithASuggestion) {
  EXPECT_EQ(error_of("odm"),
            "recorder.topics: 'odm' is not a known topic; did you mean 'odom'?; of another one say "
            "the type, too: 'odm package/msg/Type'");
  EXPECT_THAT(error_of("battery"), HasSubstr("known are: odom, goal, sensors/imu,"));
}

TEST(TopicChoice, RefusesWhatNamesNoTopicOrType) {
  const std::vector<std::pair<const char*, const char*>> cases{
      {"lidar/*", "recorder.topics: 'lidar/*' matches no known topic"},
      {"scan sensor_msgs/msg/LaserScam",
       "recorder.topics: 'sensor_msgs/msg/LaserScam' is a type that no installed IDL library has"},
      {"odom std_msgs/msg/String", "'odom' has the type sensor_msgs::msg::dds_::Imu_, not "},
      {"", "is not a name, a pattern or NAME TYPE"},
      {"a b c d e", "is not a name, a pattern or NAME TYPE"},
      {"a-b std_msgs/msg/String", "'a-b' is not a name of a topic"},
      {"a/1b std_msgs/msg/String", "is not a name of a topic"},
      {"a String", "is not a type such as"},
      {"a std_msgs/String", "is not a type such as"},
      {"a std_msgs/srv/Text", "is not a type such as"},
      {"a std-msgs/msg/Text", "is not a type such as"},
      {"a std_msgs/msg/String event radio", "'radio' is neither host nor link"},
      {"a\x1b[2J", "a\\x1b[2J"}};
  for (const auto& [wish, reason] : cases) {
    EXPECT_THAT(error_of(wish), AllOf(HasSubstr(reason), Not(HasSubstr("\x1b")))) << wish;
  }
}

}  // namespace
}  // namespace tocsin
