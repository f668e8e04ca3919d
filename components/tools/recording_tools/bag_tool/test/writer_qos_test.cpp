// SPDX-License-Identifier: Apache-2.0
#include "writer_qos.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tocsin::bag_tool {
namespace {

using bag::OfferedQos;

constexpr std::int64_t second = 1'000'000'000;

TEST(OfferedBy, TellsEachOfferOnce) {
  GraphEnd reliable;
  reliable.qos.reliability = Reliability::reliable;
  reliable.qos.durability = Durability::transient_local;
  reliable.qos.deadline_s = 0.5;
  reliable.lifespan_s = 60;
  GraphEnd best_effort;
  best_effort.qos.reliability = Reliability::best_effort;
  const auto offered = offered_by({&reliable, &best_effort, &reliable});
  ASSERT_EQ(offered.size(), 2U);
  EXPECT_EQ(offered[0].reliability, OfferedQos::Reliability::reliable);
  EXPECT_EQ(offered[0].durability, OfferedQos::Durability::transient_local);
  EXPECT_EQ(offered[0].deadline_ns, second / 2);
  EXPECT_EQ(offered[0].lifespan_ns, 60 * second);
  EXPECT_EQ(offered[0].liveliness_lease_ns, std::nullopt);
  EXPECT_EQ(offered[0].history, OfferedQos::History::unknown) << "it is not on the wire";
  EXPECT_EQ(offered[1].reliability, OfferedQos::Reliability::best_effort);
  EXPECT_EQ(offered[1].deadline_ns, std::nullopt);
}

TEST(WriterQos, WithoutARecordedOfferIsTheUsualOne) {
  const QosProfile qos = writer_qos({});
  EXPECT_EQ(qos.reliability, Reliability::reliable);
  EXPECT_EQ(qos.durability, Durability::volatile_kind);
  EXPECT_EQ(qos.depth, 10);
  EXPECT_EQ(qos.lifespan_s, HUGE_VAL);
}

TEST(WriterQos, IsWhatWasRecorded) {
  OfferedQos one;
  one.history = OfferedQos::History::keep_last;
  one.depth = 3;
  one.reliability = OfferedQos::Reliability::best_effort;
  one.deadline_ns = 2 * second;
  one.lifespan_ns = 5 * second;
  one.liveliness_lease_ns = 7 * second;
  const QosProfile qos = writer_qos({one});
  EXPECT_EQ(qos.reliability, Reliability::best_effort);
  EXPECT_EQ(qos.durability, Durability::volatile_kind);
  EXPECT_EQ(qos.history, History::keep_last);
  EXPECT_EQ(qos.depth, 3);
  EXPECT_EQ(qos.deadline_s, 2);
  EXPECT_EQ(qos.lifespan_s, 5);
  EXPECT_EQ(qos.liveliness_lease_s, 7);
}

TEST(WriterQos, SatisfiesEveryReaderThatOneOfTheWritersSatisfied) {
  OfferedQos state;
  state.durability = OfferedQos::Durability::transient_local;
  state.depth = 1;
  state.deadline_ns = 4 * second;
  OfferedQos stream;
  stream.reliability = OfferedQos::Reliability::best_effort;
  stream.deadline_ns = second;
  stream.lifespan_ns = second;
  const QosProfile qos = writer_qos({state, stream});
  EXPECT_EQ(qos.reliability, Reliability::reliable);
  EXPECT_EQ(qos.durability, Durability::transient_local);
  EXPECT_EQ(qos.deadline_s, 1);
  EXPECT_EQ(qos.lifespan_s, HUGE_VAL);
}

TEST(WriterQos, SpeaksForItselfThoughTheRecordedWriterSaidByHandThatItLives) {
  OfferedQos one;
  one.liveliness = OfferedQos::Liveliness::manual_by_topic;
  EXPECT_EQ(writer_qos({one}).liveliness, Liveliness::automatic);
}

TEST(WriterQos, TakesNoTimesThatWouldKeepTheMiddlewareBusy) {
  OfferedQos one;
  one.deadline_ns = 1;
  one.liveliness_lease_ns = 1;
  one.lifespan_ns = 1;
  one.depth = 2'000'000'000;
  const QosProfile qos = writer_qos({one});
  EXPECT_EQ(qos.deadline_s, HUGE_VAL);
  EXPECT_EQ(qos.liveliness_lease_s, HUGE_VAL);
  EXPECT_EQ(qos.lifespan_s, 0.001);
  EXPECT_EQ(qos.depth, 10'000);
  EXPECT_FALSE(conflict(qos));
}

}  // namespace
}  // namespace tocsin::bag_tool
