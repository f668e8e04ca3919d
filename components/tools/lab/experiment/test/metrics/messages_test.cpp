// SPDX-License-Identifier: Apache-2.0
#include "metrics/messages.hpp"

#include <gtest/gtest.h>

namespace tocsin::experiment {
namespace {

report::Arrival arrival(double sent_s, std::uint64_t sequence, const std::string& topic = "t",
                        const std::string& writer = "1") {
  return {sent_s, sent_s + 0.1, topic, writer, sequence, 50};
}

TEST(Messages, ThatAreMissingLieEvenlyBetweenTheirNeighbours) {
  const auto sut = messages_of({arrival(1, 1), arrival(4, 4)}, 0, 10);
  ASSERT_EQ(sut.size(), 4U);
  EXPECT_TRUE(sut[1].lost());
  EXPECT_DOUBLE_EQ(sut[1].sent_s, 2);
  EXPECT_DOUBLE_EQ(sut[2].sent_s, 3);
}

TEST(Messages, OfTwoWritersHaveNoGapBetweenThem) {
  EXPECT_EQ(messages_of({arrival(1, 1, "t", "1"), arrival(2, 9, "t", "2")}, 0, 10).size(), 2U);
  EXPECT_EQ(messages_of({arrival(1, 1, "t"), arrival(2, 9, "u")}, 0, 10).size(), 2U);
}

TEST(Messages, ThatOvertookAreNotLost) {
  EXPECT_EQ(messages_of({arrival(2, 2), arrival(1, 1)}, 0, 10).size(), 2U);
}

TEST(Messages, CountFromTheBeginUpToBeforeTheEnd) {
  const std::vector<report::Arrival> all{arrival(1, 1), arrival(2, 2), arrival(3, 3)};
  EXPECT_EQ(messages_of(all, 1, 3).size(), 2U);
  EXPECT_EQ(messages_of(all, 1.5, 3.5).size(), 2U);
}

TEST(Messages, ReceivedBeforeTheyWereSentTookNoTime) {
  report::Arrival early = arrival(5, 1);
  early.received_s = 4.9;
  EXPECT_EQ(messages_of({early}, 0, 10)[0].latency_s, 0);
}

TEST(Messages, AreInTheOrderOfTopicWriterAndSequence) {
  const auto sut = messages_of({arrival(9, 2, "b", "1"), arrival(8, 1, "b", "1"),
                                arrival(7, 1, "a", "2"), arrival(6, 1, "a", "1")},
                               0, 10);
  ASSERT_EQ(sut.size(), 4U);
  EXPECT_EQ(sut[0].sent_s, 6);
  EXPECT_EQ(sut[1].sent_s, 7);
  EXPECT_EQ(sut[2].sent_s, 8);
  EXPECT_EQ(sut[3].sent_s, 9);
}

TEST(Messages, FindTheGapOfEachWriterBetweenThoseOfOthers) {
  // Two writers by turns; each misses its second.
  const auto sut = messages_of({arrival(1, 1, "t", "1"), arrival(2, 1, "t", "2"),
                                arrival(5, 3, "t", "1"), arrival(8, 3, "t", "2")},
                               0, 10);
  ASSERT_EQ(sut.size(), 6U);
  EXPECT_TRUE(sut[1].lost());
  EXPECT_DOUBLE_EQ(sut[1].sent_s, 3);
  EXPECT_TRUE(sut[4].lost());
  EXPECT_DOUBLE_EQ(sut[4].sent_s, 5);
}

TEST(Messages, CountALostOneWhereItLiesNotWhereItsNeighboursDo) {
  // The four that are missing lie at 2, 3, 4 and 5 s; neither neighbour is in the window.
  EXPECT_EQ(messages_of({arrival(1, 1), arrival(6, 6)}, 3, 5).size(), 2U);
}

TEST(Messages, ThatCameTwiceLoseNoneBetweenThem) {
  const auto sut = messages_of({arrival(1, 1), arrival(1, 1), arrival(2, 2)}, 0, 10);
  ASSERT_EQ(sut.size(), 3U);
  for (const Message& one : sut) EXPECT_FALSE(one.lost());
}

TEST(Messages, OfARestartedWriterBeginAnew) {
  const auto sut =
      messages_of({arrival(1, 50, "t", "first life"), arrival(3, 1, "t", "second life")}, 0, 10);
  EXPECT_EQ(sut.size(), 2U);
}

}  // namespace
}  // namespace tocsin::experiment
