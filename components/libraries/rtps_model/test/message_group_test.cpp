// SPDX-License-Identifier: Apache-2.0
#include "rtps_model/message_group.hpp"

#include <gtest/gtest.h>

#include "sent_messages.hpp"

namespace tocsin::rtps {
namespace {

class MessageGroupTest : public ::testing::Test {
 protected:
  SentMessages sent_;
};

TEST_F(MessageGroupTest, SendsWhatIsLeftWhenItEnds) {
  {
    MessageGroup sut(sent_);
    sut.address({7});
    sut.add(Heartbeat{1, 1, 1});
    EXPECT_TRUE(sent_.all.empty());
  }
  ASSERT_EQ(sent_.all.size(), 1U);
  EXPECT_EQ(sent_.all[0].to, 7U);
  EXPECT_EQ(sent_.all[0].message->ip_bytes, 156U);
}

TEST_F(MessageGroupTest, NamesNoDestinationWhenThereAreTwo) {
  {
    MessageGroup sut(sent_);
    sut.address({7, 8});
    sut.add(Heartbeat{1, 1, 1});
  }
  ASSERT_EQ(sent_.all.size(), 2U);
  EXPECT_EQ(sent_.all[1].to, 8U);
  EXPECT_EQ(sent_.all[1].message->ip_bytes, 140U);
}

TEST_F(MessageGroupTest, PacksUpTo1400Bytes) {
  MessageGroup sut(sent_);
  sut.address({7});
  // 20 + 16 of the message, 36 of DATA with its time stamp, 60 of statistics.
  ASSERT_TRUE(sut.add_data(sample_of(1, 1000), 0));
  ASSERT_TRUE(sut.add_data(sample_of(2, 1400 - 20 - 16 - 60 - 2 * 36 - 1000), 0));
  EXPECT_TRUE(sent_.all.empty());
  sut.flush();
  ASSERT_EQ(sent_.all.size(), 1U);
  EXPECT_EQ(sent_.all[0].message->ip_bytes, 1428U);
}

TEST_F(MessageGroupTest, BeginsAnotherMessageForWhatDoesNotFit) {
  MessageGroup sut(sent_);
  sut.address({7});
  ASSERT_TRUE(sut.add_data(sample_of(1, 1000), 0));
  ASSERT_TRUE(sut.add_data(sample_of(2, 1400 - 20 - 16 - 60 - 2 * 36 - 1000 + 1), 0));
  sut.flush();
  EXPECT_EQ(sent_.all.size(), 2U);
}

TEST_F(MessageGroupTest, BeginsAnotherMessageForOtherReceivers) {
  MessageGroup sut(sent_);
  sut.address({7});
  sut.add(Heartbeat{1, 1, 1});
  sut.address({7});
  sut.add(Heartbeat{1, 1, 2});
  sut.address({7, 8});
  sut.add(Heartbeat{1, 1, 3});
  sut.flush();
  ASSERT_EQ(sent_.all.size(), 3U);
  EXPECT_EQ(sent_.all[0].message->parts.size(), 2U);
}

TEST_F(MessageGroupTest, CountsAMessageOnceForAllItsReceivers) {
  ByteBudget budget{5000};
  MessageGroup sut(sent_, &budget);
  sut.address({7, 8});
  ASSERT_TRUE(sut.add_data(sample_of(1, 1000), 0));
  EXPECT_EQ(budget.sent, 0U);
  EXPECT_EQ(budget.pending, 20U + 36 + 1000);
  sut.flush();
  EXPECT_EQ(budget.sent, 20U + 36 + 1000 + 60);
  EXPECT_EQ(budget.pending, 20U);
}

TEST_F(MessageGroupTest, TakesNoDataBeyondTheBudget) {
  ByteBudget budget{1020};
  MessageGroup sut(sent_, &budget);
  sut.address({7, 8});
  EXPECT_FALSE(sut.add_data(sample_of(1, 1001), 0));
  EXPECT_TRUE(sut.add_data(sample_of(1, 1000), 0));
  EXPECT_FALSE(sut.add_data(sample_of(2, 1), 0));
  sut.add(Heartbeat{1, 1, 1});  // is no data
  sut.flush();
  EXPECT_EQ(sent_.parts<Heartbeat>(7).size(), 1U);
}

TEST(ByteBudget, WithoutALimitIsNeverExceeded) {
  EXPECT_FALSE(ByteBudget{}.is_exceeded_by(1'000'000));
}

}  // namespace
}  // namespace tocsin::rtps
