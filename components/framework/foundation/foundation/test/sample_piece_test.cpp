// SPDX-License-Identifier: Apache-2.0
#include "foundation/sample_piece.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

TEST(SamplePiece, PiecesAreTheWholeSampleInOrderWithoutGaps) {
  for (const std::size_t bytes : {2U, 5U, 2400U, 30'001U}) {
    for (const int pieces : {1, 2, 5, 48}) {
      const auto count = static_cast<std::uint8_t>(pieces);
      std::size_t at = 0;
      for (std::uint8_t i = 0; i < count; ++i) {
        const SamplePiece piece{i, count};
        EXPECT_EQ(piece.begin(bytes), at) << bytes << ", " << int{i} << " of " << int{count};
        at = piece.end(bytes);
        EXPECT_EQ(piece.is_last(), i + 1 == count);
      }
      EXPECT_EQ(at, bytes);
    }
  }
}

TEST(SamplePiece, IsTheWholeSampleUnlessSaidOtherwise) {
  EXPECT_TRUE(SamplePiece{}.is_whole());
  EXPECT_TRUE(SamplePiece{}.is_last());
  EXPECT_EQ(SamplePiece{}.size(123), 123U);
}

}  // namespace
}  // namespace tocsin
