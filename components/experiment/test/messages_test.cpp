// SPDX-License-Identifier: Apache-2.0
#include "messages.hpp"

#include <gtest/gtest.h>

namespace tocsin::experiment {
namespace {

report::Arrival arrival(double sent_s, std::uint64_t sequence, const std::string& topic = "t",
                        const std::string& writer = "1") {
  return {sent_s, sent_s + 0.1, topic, writer, sequence, 50};
}

TEST(Messages, HaveTheirLatency) {
  const auto sut = messages_of({arrival(1, 1)}, 0, 10);
  ASSERT_EQ(sut.size(), 1U);
  EXPECT_FALSE(sut[0].lost());
  EXPECT_NEAR(sut[0].latency_s, 0.1, 1e-12);
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

TEST(Messages, KnowPictures) {
  EXPECT_TRUE(messages_of({arrival(1, 1, camera_topic)}, 0, 10)[0].camera);
  EXPECT_FALSE(messages_of({arrival(1, 1, "location")}, 0, 10)[0].camera);
}

TEST(Messages, ReceivedBeforeTheyWereSentTookNoTime) {
  report::Arrival early = arrival(5, 1);
  early.received_s = 4.9;
  EXPECT_EQ(messages_of({early}, 0, 10)[0].latency_s, 0);
}

}  // namespace
}  // namespace tocsin::experiment
