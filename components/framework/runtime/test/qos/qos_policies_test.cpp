// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/qos_policies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "foundation/parameters.hpp"
#include "runtime/middleware/qos_matching.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double infinite = std::numeric_limits<double>::infinity();

std::string conflicting(const QosProfile& profile) {
  const auto found = conflict(profile);
  return found ? found->policy : "";
}

/// The defaults with these policies, as a file has them.
QosProfile with(const std::string& policies) {
  return load_parameters<QosProfile>(YAML::Load(policies), "profile", "qos.yaml");
}

TEST(QosConflict, NamesThePolicyThatContradictsAnother) {
  for (const auto& [policies, conflict] : std::vector<std::pair<const char*, const char*>>{
           {"{}", ""},
           {"{depth: 5, max_samples: 5}", ""},
           {"{depth: 5, max_samples: 4}", "max_samples"},
           {"{depth: 5, max_samples: 4, history: keep_all}", ""},
           {"{allocated_samples: 2}", ""},
           {"{allocated_samples: 3}", "allocated_samples"},
           {"{durability: transient_local}", ""},
           {"{durability: transient_local, reliability: best_effort}", "durability"},
           {"{deadline_s: 1, minimum_separation_s: 1, max_rate_hz: 1}", ""},
           {"{deadline_s: 1, minimum_separation_s: 1.1}", "minimum_separation_s"},
           {"{deadline_s: 1, max_rate_hz: 0.9}", "max_rate_hz"},
           {"{durability: transient_local, minimum_separation_s: 0.1}", "minimum_separation_s"},
           {"{durability: transient_local, max_rate_hz: 10}", "max_rate_hz"},
           {"{ownership_strength: 1}", "ownership_strength"},
           {"{ownership_strength: 1, ownership: exclusive}", ""},
           {"{liveliness_lease_s: 1, liveliness_announcement_s: 0.9}", ""},
           {"{liveliness_lease_s: 1, liveliness_announcement_s: 1}",
            "liveliness_announcement_s"}}) {
    EXPECT_EQ(conflicting(with(policies)), conflict) << policies;
  }
}

TEST(Requested, IsTheProfileItselfUnlessTheTopicAsksForNothing) {
  QosProfile offered;
  offered.durability = Durability::transient_local;
  offered.deadline_s = 1;
  const QosProfile sut = requested({"odom", "state", Scope::host}, offered);
  EXPECT_EQ(sut.durability, Durability::transient_local);
  EXPECT_EQ(sut.reliability, Reliability::reliable);
  EXPECT_EQ(sut.deadline_s, 1);
}

TEST(Requested, ReadersMayAskForNoRepairOfWritersThatOfferIt) {
  QosProfile offered;
  offered.durability = Durability::transient_local;
  offered.requested_reliability = RequestedReliability::best_effort;
  const QosProfile sut = requested({"odom", "sensor", Scope::host}, offered);
  EXPECT_EQ(sut.reliability, Reliability::best_effort);
  EXPECT_EQ(sut.durability, Durability::transient_local);
  EXPECT_THAT(incompatibilities(offered, sut), ::testing::IsEmpty());
}

TEST(Requested, ATopicThatAsksForNothingMatchesEveryWriter) {
  const TopicInfo stop{"stop", "state", Scope::link, Requests::anything};
  QosProfile strict;
  strict.durability = Durability::transient_local;
  strict.deadline_s = 0.1;
  strict.liveliness = Liveliness::manual_by_topic;
  strict.liveliness_lease_s = 1;
  strict.max_samples = 2;
  const QosProfile sut = requested(stop, strict);
  EXPECT_EQ(conflicting(sut), "");
  EXPECT_GE(sut.depth, 16);
  QosContract least;
  least.reliability = Reliability::best_effort;
  EXPECT_THAT(incompatibilities(least, sut), ::testing::IsEmpty());
  EXPECT_THAT(incompatibilities(strict, sut), ::testing::IsEmpty());
}

TEST(QosConflict, UserDataIsPairsThatRos2CanRead) {
  QosProfile sut;
  for (const char* sound : {"", "a=1", "a=1;", "Mast4=of wood_2;b=2;"}) {
    sut.user_data = sound;
    EXPECT_EQ(conflicting(sut), "") << sound;
  }
  for (const char* broken : {"mine", "my_key=1;", "=1;", "a=;", "a=1;;", "a=1;b"}) {
    sut.user_data = broken;
    EXPECT_EQ(conflicting(sut), "user_data") << broken;
  }
}

TEST(QosHistory, RoomIsOneMoreThanTheDepthSoThatAWriteNeverWaits) {
  QosHistory sut;
  sut.depth = 5;
  EXPECT_EQ(sut.room(), 6);
  sut.history = History::keep_all;
  EXPECT_EQ(sut.room(), 1000);
  sut.max_samples = 7;
  EXPECT_EQ(sut.room(), 7);
}

TEST(QosDelivery, ThinsWhenARateOrASeparationIsGiven) {
  QosDelivery sut;
  EXPECT_FALSE(sut.thins());
  sut.max_rate_hz = 1e9;
  EXPECT_TRUE(sut.thins());
  sut.max_rate_hz = infinite;
  sut.minimum_separation_s = 0.001;
  EXPECT_TRUE(sut.thins());
}

TEST(Refusal, NamesTheReasonWithAndWithoutUnit) {
  EXPECT_THAT(refusal("latency_budget", ""), HasSubstr("announces it"));
  EXPECT_EQ(refusal("latency_budget_s", "1"), refusal("latency_budget", ""));
  EXPECT_THAT(refusal("time_based_filter", ""), HasSubstr("minimum_separation_s"));
}

TEST(Refusal, OfAValueLeavesTheOthers) {
  EXPECT_THAT(refusal("durability", "transient"), HasSubstr("database"));
  EXPECT_EQ(refusal("durability", "transient_local"), "");
}

TEST(Refusal, KnowsNothingAgainstOtherKeys) {
  EXPECT_EQ(refusal("deadline_s", "1"), "");
  EXPECT_EQ(refusal("no_such_policy", ""), "");
  EXPECT_EQ(refusal("_s", ""), "");
}

}  // namespace
}  // namespace tocsin
