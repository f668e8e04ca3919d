// SPDX-License-Identifier: Apache-2.0
#include "link/encoded_piece.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <utility>

namespace tocsin {
namespace {

EncodedMessage message_of(std::size_t bytes) {
  EncodedMessage message;
  message.bytes.resize(bytes);
  std::iota(message.bytes.begin(), message.bytes.end(), std::uint8_t{0});
  return message;
}

/// `padded`: as the middleware gives them.
EncodedMessage over_pieces(const EncodedMessage& whole, bool padded) {
  const auto count = static_cast<std::uint8_t>((whole.bytes.size() + 999) / 1000);
  std::vector<std::shared_ptr<const void>> pieces;
  for (std::uint8_t i = 0; i < count; ++i) {
    EncodedMessage piece = cut_out(whole, {i, count});
    if (padded) piece.bytes.resize((piece.bytes.size() + 3) / 4 * 4);
    pieces.push_back(std::make_shared<EncodedMessage>(std::move(piece)));
  }
  return put_together(pieces);
}

TEST(EncodedPiece, PiecesMakeTheSampleAgainWithoutThePaddingOfThePackets) {
  for (const std::size_t bytes : {1193U, 2376U, 2377U, 30'001U, 30'002U, 30'003U}) {
    const EncodedMessage whole = message_of(bytes);
    EXPECT_EQ(over_pieces(whole, false).bytes, whole.bytes) << bytes;
    EXPECT_EQ(over_pieces(whole, true).bytes, whole.bytes) << bytes;
  }
}

TEST(EncodedPiece, OfAPeerThatLiesAboutThePaddingNothingElseIsRead) {
  const auto piece = std::make_shared<EncodedMessage>(EncodedMessage{{0, 1, 0, 3}});
  EXPECT_TRUE(put_together({piece}).bytes.empty());
}

TEST(EncodedPiece, BeginsAsEverySerialisedSample) {
  const auto piece = cut_out(message_of(2000), {1, 2}).bytes;
  ASSERT_EQ(piece.size(), encapsulation_bytes + 1000);
  EXPECT_EQ(std::vector<std::uint8_t>(piece.begin(), piece.begin() + encapsulation_bytes),
            (std::vector<std::uint8_t>{0, 1, 0, 0}));
}

}  // namespace
}  // namespace tocsin
