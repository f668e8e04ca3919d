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

/// The defaults with one policy changed.
template <class Value, class Member>
QosContract with(Member QosContract::*policy, const Value& value) {
  QosContract contract;
  contract.*policy = value;
  return contract;
}

TEST(Incompatibilities, AWriterThatOffersLessThanIsRequestedDoesNotMatchAndOneOfMoreDoes) {
  const QosContract plain;
  const auto best_effort = with(&QosContract::reliability, Reliability::best_effort);
  const auto keeps = with(&QosContract::durability, Durability::transient_local);
  const auto slow = with(&QosContract::latency_budget_s, 0.1);
  const auto by_source = with(&QosContract::destination_order, DestinationOrder::by_source);
  const auto representations = with(&QosContract::representations,
                                    std::vector{Representation::xcdr2, Representation::xcdr1});
  const auto presented = [](PresentationScope scope, bool coherent, bool ordered) {
    return with(&QosContract::presentation, Presentation{scope, coherent, ordered});
  };
  const struct {
    QosContract less;
    QosContract more;
    const char* policy;
  } cases[] = {
      {best_effort, plain, "reliability"},
      {plain, keeps, "durability"},
      {with(&QosContract::deadline_s, 2.0), with(&QosContract::deadline_s, 1.0), "deadline"},
      {slow, plain, "latency_budget"},
      {plain, by_source, "destination_order"},
      {plain, presented(PresentationScope::topic, false, false), "presentation"},
      {plain, presented(PresentationScope::instance, true, false), "presentation"},
      {plain, presented(PresentationScope::instance, false, true), "presentation"},
      {representations, plain, "data_representation"}};
  for (const auto& [less, more, policy] : cases) {
    EXPECT_THAT(incompatibilities(less, more), ElementsAre(policy));
    EXPECT_THAT(incompatibilities(more, less), IsEmpty()) << policy;
    EXPECT_THAT(incompatibilities(more, more), IsEmpty()) << policy;
  }
}

TEST(Incompatibilities, OwnershipMustBeTheSameAndEveryPolicyThatFailsIsNamed) {
  const auto exclusive = with(&QosContract::ownership, Ownership::exclusive);
  EXPECT_THAT(incompatibilities(exclusive, {}), ElementsAre("ownership"));
  auto strict = exclusive;
  strict.deadline_s = 1;
  EXPECT_THAT(incompatibilities({}, strict), ElementsAre("deadline", "ownership"));
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

TEST(Incompatibilities, PartitionsMatchByNameAndWildcardOnEitherSide) {
  EXPECT_THAT(incompatibilities(with_partition({"a", "b"}), with_partition({"b"})), IsEmpty());
  EXPECT_THAT(incompatibilities(with_partition({"r*"}), with_partition({"robot"})), IsEmpty());
  EXPECT_THAT(incompatibilities(with_partition({"robot"}), with_partition({"r*"})), IsEmpty());
  EXPECT_THAT(incompatibilities(with_partition({"a"}), with_partition({"b"})),
              ElementsAre("partition"));
  EXPECT_THAT(incompatibilities(with_partition({}), with_partition({"a"})),
              ElementsAre("partition"));
}

/// Section 2.2.3.13: an expression stands for names.
TEST(Incompatibilities, TwoExpressionsDoNotMeetButFastDdsLetsOneMeetItself) {
  const auto expression = with_partition({"a*"});
  EXPECT_THAT(incompatibilities(expression, expression), ElementsAre("partition"));
  EXPECT_THAT(incompatibilities_for_fast_dds(expression, expression), IsEmpty());
  EXPECT_THAT(incompatibilities_for_fast_dds(expression, with_partition({"*"})),
              ElementsAre("partition"));
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
