// SPDX-License-Identifier: Apache-2.0
#include "link_router/backfill_receiver.hpp"

#include <gmock/gmock.h>

#include <string>
#include <utility>
#include <vector>

namespace tocsin::router {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Incarnation life = 7;

BackfillBatch batch_of(std::uint32_t session, std::uint32_t number,
                       const std::vector<std::uint64_t>& sequences) {
  BackfillBatch batch{session, number, 1, {}};
  for (const std::uint64_t sequence : sequences) {
    batch.samples.push_back({{1, 2, sequence}, 0, {}});
  }
  return batch;
}

class BackfillReceiverTest : public ::testing::Test {
 protected:
  BackfillReceiverTest() { sut_.recover({}); }
  /// The sequences that the host is given.
  std::vector<std::uint64_t> take(BackfillBatch batch, Incarnation of = life) {
    std::vector<std::uint64_t> given;
    for (const BackfillBatch& one : sut_.on_batch("uxv", of, std::move(batch))) {
      for (const auto& entry : one.samples) given.push_back(entry.id.sequence);
    }
    return given;
  }
  BackfillReceiver sut_;
};

TEST_F(BackfillReceiverTest, GivesEachSampleOnce) {
  EXPECT_THAT(take(batch_of(1, 1, {10, 11})), ElementsAre(10, 11));
  EXPECT_THAT(take(batch_of(1, 1, {10, 11})), IsEmpty()) << "repeated";
  EXPECT_THAT(take(batch_of(1, 2, {11, 12})), ElementsAre(12)) << "in another batch";
  EXPECT_EQ(sut_.progress("uxv", life).number, 2U);
}

TEST_F(BackfillReceiverTest, LeavesOutWhatCrossedLive) {
  EXPECT_TRUE(sut_.on_live({1, 2, 11}));
  EXPECT_FALSE(sut_.on_live({1, 2, 11}));
  EXPECT_THAT(take(batch_of(1, 1, {10, 11, 12})), ElementsAre(10, 12));
}

TEST_F(BackfillReceiverTest, KeepsWhatComesTooEarly) {
  EXPECT_THAT(take(batch_of(1, 3, {30})), IsEmpty());
  EXPECT_THAT(take(batch_of(1, 2, {20})), IsEmpty());
  EXPECT_EQ(sut_.progress("uxv", life).number, 0U);
  EXPECT_THAT(take(batch_of(1, 1, {10})), ElementsAre(10, 20, 30));
  EXPECT_EQ(sut_.progress("uxv", life).number, 3U);
}

TEST_F(BackfillReceiverTest, KeepsAtMostSixteen) {
  EXPECT_THAT(take(batch_of(1, 18, {18})), IsEmpty());
  EXPECT_THAT(take(batch_of(1, 17, {17})), IsEmpty());
  for (std::uint32_t i = 1; i <= 16; ++i) take(batch_of(1, i, {i}));
  EXPECT_EQ(sut_.progress("uxv", life).number, 16U) << "17 came beyond them";
}

TEST_F(BackfillReceiverTest, ANewSessionStartsAfreshAndRepeatsNothing) {
  take(batch_of(1, 1, {10}));
  take(batch_of(1, 2, {11}));
  EXPECT_THAT(take(batch_of(2, 1, {11, 12})), ElementsAre(12));
  EXPECT_THAT(take(batch_of(1, 3, {13})), IsEmpty()) << "of a session that is over";
  EXPECT_EQ(sut_.progress("uxv", life).session, 2U);
  EXPECT_EQ(sut_.progress("uxv", life).number, 1U);
}

TEST_F(BackfillReceiverTest, ANewLifeOfThePeerStartsAfresh) {
  take(batch_of(5, 1, {10}));
  EXPECT_EQ(sut_.progress("uxv", life + 1).number, 0U) << "that it would take for its own";
  EXPECT_THAT(take(batch_of(1, 1, {10, 11}), life + 1), ElementsAre(11));
  EXPECT_EQ(sut_.progress("uxv", life + 1).session, 1U);
  EXPECT_EQ(sut_.progress("uxv", life).session, 0U);
}

TEST_F(BackfillReceiverTest, KnowsWhatEarlierLivesHaveGiven) {
  sample_log::SampleSet given;
  given.add({1, 2}, 1, 10);
  BackfillReceiver sut;
  EXPECT_THAT(sut.on_batch("uxv", life, batch_of(1, 1, {10, 11})), IsEmpty())
      << "before that is known nothing is taken";
  EXPECT_EQ(sut.progress("uxv", life).number, 0U);
  sut.recover(given);
  const auto batches = sut.on_batch("uxv", life, batch_of(1, 1, {10, 11}));
  ASSERT_EQ(batches.size(), 1U);
  ASSERT_EQ(batches[0].samples.size(), 1U);
  EXPECT_EQ(batches[0].samples[0].id.sequence, 11U);
}

TEST_F(BackfillReceiverTest, TellsPeersApart) {
  take(batch_of(1, 1, {10}));
  EXPECT_EQ(sut_.progress("other", life).number, 0U);
  EXPECT_NE(BackfillReceiver::stream_key("uxv", "odom|"),
            BackfillReceiver::stream_key("uxv2", "odom|"));
}

}  // namespace
}  // namespace tocsin::router
