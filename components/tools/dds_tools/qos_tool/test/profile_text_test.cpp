// SPDX-License-Identifier: Apache-2.0
#include "profile_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "foundation/error.hpp"

namespace tocsin::qos_tool {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::vector<TopicUse> uses{{"odom", "sensor", false}, {"location", "sensor", true}};

TEST(ProfileText, ListsEachProfileWithWhatDiffersAndItsTopics) {
  const QosProfiles profiles(TOCSIN_REPOSITORY "/config/qos.yaml");
  const std::string text = list_text(profiles, uses);
  EXPECT_THAT(text, HasSubstr("sensor: {depth: 5, requested_reliability: best_effort}\n"
                              "  location (link), odom\n"));
  EXPECT_THAT(text, HasSubstr("event: {depth: 100, heartbeat_period_s: 0.1}\n  no topic of"));
  const auto json = list_json(profiles, uses);
  EXPECT_EQ(json.size(), 7U);
  for (const auto& one : json) {
    if (one["profile"] != "sensor") continue;
    EXPECT_EQ(one["topics"][1]["name"], "location");
    EXPECT_EQ(one["policies"]["depth"]["value"], "5");
  }
}

TEST(ProfileText, AnUnknownProfileIsRefusedWithWhatIsLikeIt) {
  const QosProfiles profiles(TOCSIN_REPOSITORY "/config/qos.yaml");
  EXPECT_EQ(find_profile(profiles, "event").depth, 100);
  try {
    (void)find_profile(profiles, "sensr");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("'sensr' is not a profile of"),
                                    HasSubstr("did you mean 'sensor'")));
  }
}

TEST(ProfileText, ShowsDefaultsOnlyWhenAsked) {
  QosProfile profile;
  profile.depth = 3;
  EXPECT_EQ(show_text("p", profile, false), "p: {depth: 3}\n");
  EXPECT_THAT(show_text("p", profile, true),
              AllOf(HasSubstr("  depth: 3\n"), HasSubstr("  deadline_s: .inf  # default\n"),
                    HasSubstr("  user_data: ''  # default\n")));
  EXPECT_EQ(show_json("p", profile)["policies"]["deadline_s"]["default"], true);
}

TEST(ProfileText, TellsWhatDiffersWithItsMeaning) {
  QosProfile one;
  QosProfile other;
  EXPECT_EQ(diff_text(one, other), "no difference\n");
  other.lifespan_s = 5;
  EXPECT_EQ(diff_text(one, other),
            "lifespan_s: .inf -> 5\n  [s] an older sample is never delivered\n");
  EXPECT_EQ(diff_json(one, other).dump(), R"({"lifespan_s":[".inf","5"]})");
}

TEST(ProfileText, KnowsTheTopicsOfTheInstalledLibraries) {
  bool found = false;
  for (const TopicUse& use : known_uses()) {
    found = found || (use.topic == "mission_status" && use.crosses_link);
  }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace tocsin::qos_tool
