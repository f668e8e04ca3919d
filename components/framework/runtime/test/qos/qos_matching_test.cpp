// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/qos_matching.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double infinite = std::numeric_limits<double>::infinity();

QosContract with_partition(std::vector<std::string> names) {
  QosContract contract;
  contract.partition = std::move(names);
  return contract;
}
QosContract with_liveliness(Liveliness kind, double lease_s) {
  QosContract contract;
  contract.liveliness = kind;
  contract.liveliness_lease_s = lease_s;
  return contract;
}
TEST(Incompatibilities, AProfileMatchesItself) {
  EXPECT_THAT(incompatibilities(QosProfile{}, QosProfile{}), IsEmpty());
}

TEST(Incompatibilities, ABestEffortWriterDoesNotSatisfyAReliableReader) {
  QosContract best_effort;
  best_effort.reliability = Reliability::best_effort;
  EXPECT_THAT(incompatibilities(best_effort, {}), ElementsAre("reliability"));
  EXPECT_THAT(incompatibilities({}, best_effort), IsEmpty());
}

TEST(Incompatibilities, AVolatileWriterDoesNotSatisfyAReaderOfOldSamples) {
  QosContract keeps;
  keeps.durability = Durability::transient_local;
  EXPECT_THAT(incompatibilities({}, keeps), ElementsAre("durability"));
  EXPECT_THAT(incompatibilities(keeps, {}), IsEmpty());
}

TEST(Incompatibilities, TheWriterMustPromiseNoLongerDeadlineThanIsRequested) {
  QosContract one;
  one.deadline_s = 1;
  QosContract two;
  two.deadline_s = 2;
  EXPECT_THAT(incompatibilities(one, one), IsEmpty());
  EXPECT_THAT(incompatibilities(one, two), IsEmpty());
  EXPECT_THAT(incompatibilities(two, one), ElementsAre("deadline"));
}

TEST(Incompatibilities, LivelinessNeedsAtLeastTheKindAndAtMostTheLease) {
  const auto automatic = with_liveliness(Liveliness::automatic, 1);
  const auto by_participant = with_liveliness(Liveliness::manual_by_participant, 1);
  const auto by_topic = with_liveliness(Liveliness::manual_by_topic, 1);
  EXPECT_THAT(incompatibilities(by_topic, by_participant), IsEmpty());
  EXPECT_THAT(incompatibilities(by_participant, by_topic), ElementsAre("liveliness"));
  EXPECT_THAT(incompatibilities(automatic, by_participant), ElementsAre("liveliness"));
  EXPECT_THAT(incompatibilities(with_liveliness(Liveliness::automatic, 1.1), automatic),
              ElementsAre("liveliness"));
}

TEST(Incompatibilities, OwnershipMustBeTheSame) {
  QosContract exclusive;
  exclusive.ownership = Ownership::exclusive;
  EXPECT_THAT(incompatibilities(exclusive, {}), ElementsAre("ownership"));
  EXPECT_THAT(incompatibilities({}, exclusive), ElementsAre("ownership"));
}

TEST(Incompatibilities, PartitionsMatchByNameAndWildcardOnEitherSide) {
  EXPECT_THAT(incompatibilities(with_partition({"a", "b"}), with_partition({"b"})), IsEmpty());
  EXPECT_THAT(incompatibilities(with_partition({"r*"}), with_partition({"robot"})), IsEmpty());
  EXPECT_THAT(incompatibilities(with_partition({"robot"}), with_partition({"r*"})), IsEmpty());
  EXPECT_THAT(incompatibilities(with_partition({"a"}), with_partition({"b"})),
              ElementsAre("partition"));
  EXPECT_THAT(incompatibilities(with_partition({}), with_partition({"a"})),
              ElementsAre("partition"));
}

TEST(Incompatibilities, NamesEveryPolicyThatFails) {
  QosContract strict;
  strict.durability = Durability::transient_local;
  strict.deadline_s = 1;
  EXPECT_THAT(incompatibilities({}, strict), ElementsAre("durability", "deadline"));
}

/// Section 2.2.3.13: an expression stands for names.
TEST(Incompatibilities, TwoExpressionsDoNotMeetButFastDdsLetsOneMeetItself) {
  const auto expression = with_partition({"a*"});
  EXPECT_THAT(incompatibilities(expression, expression), ElementsAre("partition"));
  EXPECT_THAT(incompatibilities_for_fast_dds(expression, expression), IsEmpty());
  EXPECT_THAT(incompatibilities_for_fast_dds(expression, with_partition({"*"})),
              ElementsAre("partition"));
}

TEST(Incompatibilities, AReaderThatWantsSamplesSoonerIsNotSatisfied) {
  QosContract slow;
  slow.latency_budget_s = 0.1;
  EXPECT_THAT(incompatibilities(slow, {}), ElementsAre("latency_budget"));
  EXPECT_THAT(incompatibilities({}, slow), IsEmpty());
}

TEST(Incompatibilities, OrderBySourceIsMoreThanOrderByReception) {
  QosContract by_source;
  by_source.destination_order = DestinationOrder::by_source;
  EXPECT_THAT(incompatibilities({}, by_source), ElementsAre("destination_order"));
  EXPECT_THAT(incompatibilities(by_source, {}), IsEmpty());
}

TEST(Incompatibilities, PresentationIsOfferedInScopeCoherenceAndOrder) {
  for (const Presentation& more : {Presentation{PresentationScope::topic, false, false},
                                   Presentation{PresentationScope::instance, true, false},
                                   Presentation{PresentationScope::instance, false, true}}) {
    QosContract one;
    one.presentation = more;
    EXPECT_THAT(incompatibilities({}, one), ElementsAre("presentation"));
    EXPECT_THAT(incompatibilities(one, {}), IsEmpty());
  }
}

TEST(Incompatibilities, AWriterUsesTheFirstOfItsRepresentations) {
  QosContract both;
  both.representations = {Representation::xcdr2, Representation::xcdr1};
  EXPECT_THAT(incompatibilities(both, {}), ElementsAre("data_representation"));
  EXPECT_THAT(incompatibilities({}, both), IsEmpty());
}

TEST(Incompatibilities, FastDdsDoesNotLookAtWhatItOnlyAnnounces) {
  QosContract demanding;
  demanding.destination_order = DestinationOrder::by_source;
  demanding.presentation.coherent = true;
  demanding.representations = {Representation::xcdr2};
  EXPECT_THAT(incompatibilities({}, demanding),
              ElementsAre("destination_order", "presentation", "data_representation"));
  EXPECT_THAT(incompatibilities_for_fast_dds({}, demanding), IsEmpty());
}

TEST(MatchingRules, ShowTheValuesOfAContractInWords) {
  QosContract contract;
  contract.deadline_s = 0.5;
  contract.liveliness_lease_s = infinite;
  std::vector<std::string> values;
  for (const MatchingRule& rule : matching_rules()) values.push_back(rule.value(contract));
  EXPECT_THAT(values, ElementsAre("reliable", "volatile", "0.5 s", "automatic, for ever", "shared",
                                  "''", "0 s", "by_reception", "instance", "xcdr1"));
}

}  // namespace
}  // namespace tocsin
