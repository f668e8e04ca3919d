// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/qos_policies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(QosConflict, ThereIsNoneInTheDefaults) { EXPECT_EQ(conflicting({}), ""); }

TEST(QosConflict, MaxSamplesMustHoldTheDepthOfKeepLast) {
  QosProfile sut;
  sut.depth = 5;
  sut.max_samples = 5;
  EXPECT_EQ(conflicting(sut), "");
  sut.max_samples = 4;
  EXPECT_EQ(conflicting(sut), "max_samples");
  sut.history = History::keep_all;
  EXPECT_EQ(conflicting(sut), "");
}

TEST(QosConflict, NoMoreIsAllocatedThanThereIsRoom) {
  QosProfile sut;
  sut.allocated_samples = 2;
  EXPECT_EQ(conflicting(sut), "");
  sut.allocated_samples = 3;
  EXPECT_EQ(conflicting(sut), "allocated_samples");
}

TEST(QosConflict, OldSamplesNeedRepair) {
  QosProfile sut;
  sut.durability = Durability::transient_local;
  EXPECT_EQ(conflicting(sut), "");
  sut.reliability = Reliability::best_effort;
  EXPECT_EQ(conflicting(sut), "durability");
}

TEST(QosConflict, ThinningMustLeaveWhatTheDeadlineNeeds) {
  QosProfile sut;
  sut.deadline_s = 1;
  sut.minimum_separation_s = 1;
  sut.max_rate_hz = 1;
  EXPECT_EQ(conflicting(sut), "");
  sut.minimum_separation_s = 1.1;
  EXPECT_EQ(conflicting(sut), "minimum_separation_s");
  sut.minimum_separation_s = 0;
  sut.max_rate_hz = 0.9;
  EXPECT_EQ(conflicting(sut), "max_rate_hz");
}

TEST(QosConflict, ThinningWouldLoseTheLastState) {
  QosProfile sut;
  sut.durability = Durability::transient_local;
  sut.minimum_separation_s = 0.1;
  EXPECT_EQ(conflicting(sut), "minimum_separation_s");
  sut.minimum_separation_s = 0;
  sut.max_rate_hz = 10;
  EXPECT_EQ(conflicting(sut), "max_rate_hz");
}

TEST(QosConflict, AFlowControllerNeedsAnAsynchronousWriter) {
  QosProfile sut;
  sut.flow_controller = "radio";
  EXPECT_EQ(conflicting(sut), "");
  sut.publish_mode = PublishMode::synchronous;
  EXPECT_EQ(conflicting(sut), "flow_controller");
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

TEST(QosConflict, StrengthNeedsExclusiveOwnership) {
  QosProfile sut;
  sut.ownership_strength = 1;
  EXPECT_EQ(conflicting(sut), "ownership_strength");
  sut.ownership = Ownership::exclusive;
  EXPECT_EQ(conflicting(sut), "");
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

TEST(QosConflict, SignsOfLifeComeMoreOftenThanTheLease) {
  QosProfile sut;
  sut.liveliness_lease_s = 1;
  sut.liveliness_announcement_s = 0.9;
  EXPECT_EQ(conflicting(sut), "");
  sut.liveliness_announcement_s = 1;
  EXPECT_EQ(conflicting(sut), "liveliness_announcement_s");
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
