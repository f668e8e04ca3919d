// SPDX-License-Identifier: Apache-2.0
#include "link/encoded_piece.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace tocsin {
namespace {

EncodedMessage message_of(std::size_t bytes) {
  EncodedMessage message;
  message.bytes.resize(bytes);
  std::iota(message.bytes.begin(), message.bytes.end(), std::uint8_t{0});
  return message;
}

TEST(EncodedPiece, PiecesMakeTheSampleAgain) {
  for (const std::size_t bytes : {1193U, 2376U, 30'001U}) {
    const EncodedMessage whole = message_of(bytes);
    const auto count = static_cast<std::uint8_t>((bytes + 999) / 1000);
    std::vector<std::shared_ptr<const void>> pieces;
    for (std::uint8_t i = 0; i < count; ++i) {
      pieces.push_back(std::make_shared<EncodedMessage>(cut_out(whole, {i, count})));
    }
    EXPECT_EQ(put_together(pieces).bytes, whole.bytes);
  }
}

TEST(EncodedPiece, BeginsAsEverySerialisedSample) {
  const auto piece = cut_out(message_of(2000), {1, 2}).bytes;
  ASSERT_EQ(piece.size(), encapsulation_bytes + 1000);
  EXPECT_EQ(std::vector<std::uint8_t>(piece.begin(), piece.begin() + encapsulation_bytes),
            (std::vector<std::uint8_t>{0, 1, 0, 0}));
}

}  // namespace
}  // namespace tocsin
