// SPDX-License-Identifier: Apache-2.0
#include "fast_dds_v2/message_pieces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace tocsin {
namespace {

using Bytes = std::vector<std::uint8_t>;
using std::chrono::seconds;
using ::testing::Each;
using ::testing::SizeIs;

constexpr Time start{seconds(1000)};
constexpr std::uint64_t someone = 7;

/// An RTPS message of this size: header, and whatever.
Bytes message_of(std::size_t size, unsigned seed = 1) {
  Bytes message{'R', 'T', 'P', 'S', 2, 2, 1, 15};
  std::mt19937 random(seed);
  while (message.size() < size) message.push_back(static_cast<std::uint8_t>(random()));
  return message;
}

std::vector<Bytes> cut(MessagePieces& sut, const Bytes& message) {
  return sut.of(message.data(), message.size());
}

PieceAssembly::Result add(PieceAssembly& sut, const Bytes& packet, Time now = start,
                          std::uint64_t sender = someone) {
  return sut.add(packet.data(), packet.size(), sender, now);
}

TEST(MessagePieces, AShortMessageStaysAsItIs) {
  MessagePieces sut;
  const Bytes message = message_of(radio_message_bytes);
  EXPECT_EQ(cut(sut, message), std::vector<Bytes>{message});
  PieceAssembly assembly;
  EXPECT_FALSE(add(assembly, message).piece);
}

TEST(MessagePieces, NoPieceIsLongerThanAPacketOfTheRadio) {
  MessagePieces sut;
  for (const std::size_t size : {1401U, 1402U, 2727U, 2728U, 2729U, 30'000U, 65'507U}) {
    for (const Bytes& piece : cut(sut, message_of(size))) {
      EXPECT_LE(piece.size(), radio_message_bytes);
      EXPECT_EQ(piece.size() % 4, 0U) << "RTPS 2.2 section 9.4.1";
    }
  }
}

TEST(MessagePieces, ComeTogetherInAnyOrder) {
  MessagePieces sut;
  std::mt19937 random(3);
  for (const std::size_t size : {1401U, 1403U, 2728U, 4000U, 65'507U}) {
    const Bytes message = message_of(size);
    auto pieces = cut(sut, message);
    std::shuffle(pieces.begin(), pieces.end(), random);
    PieceAssembly assembly;
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
      const auto result = add(assembly, pieces[i]);
      EXPECT_TRUE(result.piece);
      EXPECT_FALSE(result.whole);
    }
    EXPECT_EQ(add(assembly, pieces.back()).whole, message) << size;
    EXPECT_EQ(assembly.open(), 0U);
  }
}

TEST(MessagePieces, OneThatComesTwiceCountsOnce) {
  MessagePieces sut;
  const auto pieces = cut(sut, message_of(2000));
  PieceAssembly assembly;
  EXPECT_FALSE(add(assembly, pieces[0]).whole);
  EXPECT_FALSE(add(assembly, pieces[0]).whole);
  EXPECT_TRUE(add(assembly, pieces[1]).whole);
}

TEST(MessagePieces, OfTwoSendersAreNotMixed) {
  MessagePieces one;
  MessagePieces other;
  const auto pieces = cut(one, message_of(2000, 1));
  const auto others = cut(other, message_of(2000, 2));
  PieceAssembly assembly;
  EXPECT_FALSE(add(assembly, pieces[0], start, 1).whole);
  EXPECT_FALSE(add(assembly, others[1], start, 2).whole);
  EXPECT_EQ(add(assembly, pieces[1], start, 1).whole, message_of(2000, 1));
  EXPECT_EQ(add(assembly, others[0], start, 2).whole, message_of(2000, 2));
}

TEST(MessagePieces, OfTwoMessagesAreNotMixed) {
  MessagePieces sut;
  const auto first = cut(sut, message_of(2000, 1));
  const auto second = cut(sut, message_of(2000, 2));
  PieceAssembly assembly;
  EXPECT_FALSE(add(assembly, first[0]).whole);
  EXPECT_EQ((add(assembly, second[1]), add(assembly, second[0]).whole), message_of(2000, 2));
}

TEST(MessagePieces, AreAsManyAsTheMessageNeeds) {
  MessagePieces sut;
  EXPECT_THAT(cut(sut, message_of(1401)), SizeIs(2));
  EXPECT_THAT(cut(sut, message_of(2728)), SizeIs(2));
  EXPECT_THAT(cut(sut, message_of(2729)), SizeIs(3));
}

TEST(PieceAssembly, ForgetsWhatIsNotCompleteInTime) {
  MessagePieces sut;
  const auto pieces = cut(sut, message_of(2000));
  PieceAssembly assembly;
  (void)add(assembly, pieces[0]);
  EXPECT_FALSE(add(assembly, pieces[1], start + PieceAssembly::longest_wait + seconds(1)).whole);
}

TEST(PieceAssembly, KeepsNoMoreThanItsMost) {
  MessagePieces sut;
  PieceAssembly assembly;
  const auto oldest = cut(sut, message_of(2000));
  (void)add(assembly, oldest[0]);
  for (std::size_t i = 0; i < PieceAssembly::most_open; ++i) {
    (void)add(assembly, cut(sut, message_of(65'507))[0]);
  }
  EXPECT_EQ(assembly.open(), PieceAssembly::most_open);
  EXPECT_FALSE(add(assembly, oldest[1]).whole) << "the oldest went";
}

TEST(PieceAssembly, AnythingElseIsNoPieceOrIsIgnored) {
  MessagePieces sut;
  const Bytes good = cut(sut, message_of(2000))[0];
  std::mt19937 random(11);
  PieceAssembly assembly;
  for (int i = 0; i < 20'000; ++i) {
    Bytes mutated = good;
    for (int changes = 0; changes < 3; ++changes) {
      mutated[20 + random() % 20] = static_cast<std::uint8_t>(random());
    }
    mutated.resize(random() % (mutated.size() + 1));
    (void)add(assembly, mutated);
  }
  EXPECT_LE(assembly.open(), PieceAssembly::most_open);
  for (const std::size_t size : {0U, 1U, 20U, 23U, 24U, 35U, 36U}) {
    EXPECT_FALSE(add(assembly, Bytes(good.begin(), good.begin() + static_cast<int>(size))).whole);
  }
}

}  // namespace
}  // namespace tocsin
