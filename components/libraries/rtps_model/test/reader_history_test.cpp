// SPDX-License-Identifier: Apache-2.0
#include "rtps_model/reader_history.hpp"

#include <gtest/gtest.h>

#include "sent_messages.hpp"

namespace tocsin::rtps {
namespace {

using Taken = ReaderHistory::Taken;

constexpr EndId writer = 7;
constexpr EndId other = 8;

ReaderSettings keep_last(std::size_t depth) {
  ReaderSettings settings;
  settings.depth = depth;
  settings.room = depth + 1;
  return settings;
}

ReaderSettings keep_all(std::size_t room) {
  ReaderSettings settings;
  settings.keep_all = true;
  settings.room = room;
  return settings;
}

Data whole(Sequence sequence, double written_s = 0) {
  return {sample_of(sequence, 100, at(written_s)), 0};
}
Data piece(Sequence sequence, Fragment fragment) {
  return {sample_of(sequence, 3000, at(static_cast<double>(sequence))), fragment};
}

std::vector<Sequence> taken(ReaderHistory& sut, EndId from, Sequence last) {
  std::vector<Sequence> all;
  for (const SamplePtr& one : sut.take(from, last)) all.push_back(one->sequence);
  return all;
}

TEST(ReaderHistory, GivesWholeSamplesUpToTheAvailableOneInOrder) {
  ReaderHistory sut(keep_last(5));
  for (const Sequence sequence : {3, 1, 2, 5}) {
    EXPECT_EQ(sut.add(writer, whole(sequence), 0).taken, Taken::kept);
  }
  EXPECT_EQ(taken(sut, writer, 3), (std::vector<Sequence>{1, 2, 3}));
  EXPECT_TRUE(taken(sut, writer, 3).empty());
  EXPECT_TRUE(sut.has({writer, 5}));
}

TEST(ReaderHistory, OfDepthOneTakesASampleWhileOneIsMissingAndRefusesItWhileTwoAre) {
  ReaderHistory sut(keep_last(1));
  EXPECT_EQ(sut.add(writer, whole(3), 2).taken, Taken::rejected);
  EXPECT_EQ(sut.add(writer, whole(2), 1).taken, Taken::kept);
}

TEST(ReaderHistory, MakesRoomForANewerSampleByTheOldestWholeOne) {
  ReaderHistory sut(keep_last(1));
  (void)sut.add(writer, whole(2, 1), 0);
  const auto added = sut.add(writer, whole(3, 2), 0);
  EXPECT_EQ(added.taken, Taken::kept);
  EXPECT_TRUE(added.dropped.empty());
  EXPECT_FALSE(sut.has({writer, 2}));
}

TEST(ReaderHistory, TellsWhichUnfinishedSampleMadeRoom) {
  ReaderHistory sut(keep_last(1));
  (void)sut.add(writer, piece(2, 1), 0);
  const auto added = sut.add(writer, piece(3, 1), 0);
  EXPECT_EQ(added.taken, Taken::kept);
  ASSERT_EQ(added.dropped.size(), 1U);
  EXPECT_EQ(added.dropped[0].sequence, 2U);
}

TEST(ReaderHistory, WantsNoSampleOlderThanAllThatItKeeps) {
  ReaderHistory sut(keep_last(1));
  (void)sut.add(writer, whole(3, 5), 0);
  EXPECT_EQ(sut.add(other, whole(9, 4), 0).taken, Taken::too_old);
  EXPECT_EQ(sut.add(other, whole(9, 5), 0).taken, Taken::kept);
}

TEST(ReaderHistory, OfKeepAllRefusesWhatItHasNoRoomFor) {
  ReaderHistory sut(keep_all(3));
  EXPECT_EQ(sut.add(writer, whole(4), 3).taken, Taken::rejected);
  EXPECT_EQ(sut.add(writer, whole(3), 2).taken, Taken::kept);
  EXPECT_EQ(sut.add(writer, whole(2), 1).taken, Taken::kept);
  EXPECT_EQ(sut.add(writer, whole(1), 0).taken, Taken::kept);
  EXPECT_EQ(sut.add(writer, whole(5), 0).taken, Taken::rejected);
}

TEST(ReaderHistory, PutsPiecesTogether) {
  ReaderHistory sut(keep_last(1));
  (void)sut.add(writer, piece(1, 2), 0);
  EXPECT_FALSE(sut.is_whole({writer, 1}));
  EXPECT_EQ(sut.missing_pieces({writer, 1}), (std::vector<Fragment>{1, 3}));
  EXPECT_FALSE(sut.add_piece(writer, piece(1, 2)));  // twice
  EXPECT_FALSE(sut.add_piece(writer, piece(1, 3)));
  EXPECT_TRUE(taken(sut, writer, 1).empty());
  EXPECT_TRUE(sut.add_piece(writer, piece(1, 1)));
  EXPECT_TRUE(sut.is_whole({writer, 1}));
  EXPECT_EQ(taken(sut, writer, 1), std::vector<Sequence>{1});
}

TEST(ReaderHistory, NamesMissingPiecesWithinTheLengthOfAList) {
  ReaderHistory sut(keep_last(1));
  const SamplePtr large = sample_of(1, 300 * 1224);
  (void)sut.add(writer, {large, 1}, 0);
  EXPECT_EQ(sut.missing_pieces({writer, 1}).size(), 256U);
  EXPECT_EQ(sut.missing_pieces({writer, 1}).back(), 257U);
  EXPECT_TRUE(sut.missing_pieces({writer, 2}).empty());
}

TEST(ReaderHistory, DropsUnfinishedSamplesOfAWriterOnly) {
  ReaderHistory sut(keep_last(4));
  (void)sut.add(writer, piece(1, 1), 0);
  (void)sut.add(writer, whole(2, 2), 0);
  (void)sut.add(writer, piece(3, 1), 0);
  (void)sut.add(other, piece(1, 1), 0);
  sut.drop_pieces_before(writer, 3);
  EXPECT_FALSE(sut.has({writer, 1}));
  EXPECT_TRUE(sut.has({writer, 2}));
  EXPECT_TRUE(sut.has({writer, 3}));
  EXPECT_TRUE(sut.has({other, 1}));
  sut.drop_pieces_of({writer, 3});
  sut.drop_pieces_of({writer, 2});
  EXPECT_FALSE(sut.has({writer, 3}));
  EXPECT_TRUE(sut.has({writer, 2}));
  sut.forget(writer);
  EXPECT_FALSE(sut.has({writer, 2}));
  EXPECT_TRUE(sut.has({other, 1}));
}

}  // namespace
}  // namespace tocsin::rtps
