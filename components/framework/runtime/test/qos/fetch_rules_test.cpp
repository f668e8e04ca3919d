// SPDX-License-Identifier: Apache-2.0
// The list `fetch` of a traffic file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "qos/config_file.hpp"
#include "runtime/middleware/traffic_rules.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A file of a vehicle that logs odom and pictures, with these rules.
ConfigFile file_with(const std::string& rules) {
  return ConfigFile("uxv:\n  low: {log: [odom, 'camera/*']}\n  fetch: " + rules + "\n");
}
std::vector<FetchRule> rules_of(const std::string& rules) {
  const ConfigFile file = file_with(rules);
  return TrafficRules(file.path(), Role::uxv).fetches();
}
std::string error_of_rules(const std::string& rules) {
  const ConfigFile file = file_with(rules);
  return error_of([&] { TrafficRules(file.path(), Role::uxv); });
}

TEST(FetchRules, SayWhenWhatCrosses) {
  const auto sut = rules_of(
      "[{when: emergency_stop, field: data, topics: ['*'], before_s: 3, after_s: 4,"
      " min_interval_s: 7},"
      " {when: odom, field: twist.twist.linear.x, above: 0.5, topics: [odom, camera/image]},"
      " {when: battery, field: v, above: -9, below: -1, topics: [odom]}, {when: bump, topics: "
      "[odom]}]");
  ASSERT_THAT(sut, SizeIs(4));
  EXPECT_EQ(sut[0].when, "emergency_stop");
  EXPECT_EQ(sut[0].field, "data");
  EXPECT_EQ(sut[0].above, 0) << "a truth, or a number above zero";
  EXPECT_EQ(sut[0].before_s, 3);
  EXPECT_EQ(sut[0].after_s, 4);
  EXPECT_EQ(sut[0].min_interval_s, 7);
  EXPECT_EQ(sut[1].above, 0.5);
  EXPECT_THAT(sut[1].topics, ElementsAre("odom", "camera/image"));
  EXPECT_EQ(sut[1].before_s, 10);
  EXPECT_EQ(sut[2].above, -9);
  EXPECT_EQ(sut[2].below, -1);
  EXPECT_EQ(sut[3].field, "");
  EXPECT_EQ(sut[3].name, "uxv.fetch[3]");
}

TEST(FetchRules, AreOfTheirRoleAlone) {
  const ConfigFile file(
      "uxv:\n  low: {log: [odom]}\n  fetch: [{when: bump, topics: [odom]}]\n"
      "gcs:\n  low: {topics: [goal]}\n");
  EXPECT_THAT(TrafficRules(file.path(), Role::gcs).fetches(), IsEmpty());
}

TEST(FetchRules, ThatSayTooLittleOrTooMuchAreOneErrorWithItsPlace) {
  const struct {
    const char* rule;
    const char* error;
  } cases[] = {
      {"bump", "uxv.fetch: is no list of rules"},
      {"[{topics: [odom]}]", "uxv.fetch[0].when: a topic is to be named here"},
      {"[{when: bump}]", "uxv.fetch[0].topics: topics that cross are to be named here"},
      {"[{when: bump, field: x, below: 0, topics: [odom]}]",
       "uxv.fetch[0].above: is not less than below"},
      {"[{when: bump, topics: [odom], before_s: 0, after_s: 0}]", "nothing is between them"},
      {"[{when: bump, topics: [odom], before_s: 601}]",
       "uxv.fetch[0].before_s: 601 is outside [0, 600]"},
      {"[{when: bump, topics: [odom]}, {when: bump, topic: [odom]}]", "uxv.fetch[1].topic"},
      {"[{when: bump, topics: [odmo]}]",
       "uxv.fetch[0].topics: odmo is in no list log of this role; did you mean 'odom'?"},
  };
  for (const auto& one : cases) {
    EXPECT_THAT(error_of_rules(one.rule), HasSubstr(one.error));
    EXPECT_THAT(error_of_rules(one.rule), HasSubstr(":3")) << "the line";
  }
  const ConfigFile file("uxv:\n  low: {topics: [odom]}\n  fetch: [{when: b, topics: ['*']}]\n");
  EXPECT_THAT(error_of([&] { TrafficRules(file.path(), Role::uxv); }),
              HasSubstr("uxv.fetch[0].topics: * is in no list log"));
}

}  // namespace
}  // namespace tocsin
