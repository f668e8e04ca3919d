// SPDX-License-Identifier: Apache-2.0
#include "foundation/hash.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

TEST(HashOf, IsFnv1a) {
  EXPECT_EQ(hash_of(""), 0xcbf29ce484222325ULL);
  EXPECT_EQ(hash_of("a"), 0xaf63dc4c8601ec8cULL);  // published test vectors of FNV-1a 64
  EXPECT_EQ(hash_of("foobar"), 0x85944171f73967e8ULL);
}

TEST(HashOf, TakesAZeroAndBytesAboveAsciiAsTheyAre) {
  EXPECT_NE(hash_of(std::string_view("a\0b", 3)), hash_of("a"));
  static_assert(hash_of("\xff") == (14695981039346656037ULL ^ 0xFFU) * 1099511628211ULL);
}

}  // namespace
}  // namespace tocsin
