// SPDX-License-Identifier: Apache-2.0
#include "link/expected_peers.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

using Judgement = ExpectedPeers::Judgement;

ExpectedPeers::Participant participant(std::uint8_t number) {
  ExpectedPeers::Participant made;
  made.value[3] = number;
  return made;
}

TEST(ExpectedPeers, TakesWhoeverComesWhereNobodyIsNamed) {
  ExpectedPeers sut({});
  EXPECT_EQ(sut.judge(participant(1), "uxv"), Judgement::expected);
  EXPECT_TRUE(sut.takes_subject("CN=/anybody"));
  EXPECT_FALSE(sut.is_refused(participant(1)));
}

TEST(ExpectedPeers, RefusesEachStrangeNameOnceAndItsParticipantsUntilTheyLeave) {
  ExpectedPeers sut({"uxv1"});
  EXPECT_EQ(sut.judge(participant(1), "uxv1"), Judgement::expected);
  EXPECT_EQ(sut.judge(participant(2), "uxv12"), Judgement::refused);
  EXPECT_EQ(sut.judge(participant(3), "uxv12"), Judgement::refused_before);
  EXPECT_FALSE(sut.is_refused(participant(1)));
  EXPECT_TRUE(sut.is_refused(participant(3)));
  EXPECT_TRUE(sut.forget(participant(3)));
  EXPECT_FALSE(sut.is_refused(participant(3)));
  EXPECT_FALSE(sut.forget(participant(1)));
}

TEST(ExpectedPeers, WhoInventsNamesFillsNoLog) {
  ExpectedPeers sut({"uxv1"});
  std::size_t told = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto judgement = sut.judge(participant(1), "stranger" + std::to_string(i));
    told += judgement == Judgement::refused ? 1 : 0;
  }
  EXPECT_EQ(told, ExpectedPeers::most_told);
}

TEST(ExpectedPeers, KnowsTheSubjectOfACertificate) {
  const ExpectedPeers sut({"uxv1"});
  EXPECT_TRUE(sut.takes_subject("CN=/uxv1"));
  EXPECT_FALSE(sut.takes_subject("CN=/uxv12"));
  EXPECT_FALSE(sut.takes_subject("uxv1"));
  EXPECT_FALSE(sut.takes_subject(""));
}

}  // namespace
}  // namespace tocsin
