// SPDX-License-Identifier: Apache-2.0
#include "numbered.hpp"

#include <gtest/gtest.h>

namespace tocsin::sample_log {
namespace {

TEST(Numbered, ANameHasItsNumberBack) {
  for (const std::uint64_t number : {0ULL, 1ULL, 42ULL, 99'999'999ULL, 123'456'789'012ULL}) {
    EXPECT_EQ(number_in(numbered("segment", number, ".mcap"), "segment", ".mcap"), number);
    EXPECT_EQ(number_in(numbered("given", number, ""), "given", ""), number);
  }
}

TEST(Numbered, SortedByNameTheyAreSortedByNumber) {
  EXPECT_EQ(numbered("segment", 9, ".mcap"), "segment.00000009.mcap");
  EXPECT_LT(numbered("segment", 9, ".mcap"), numbered("segment", 10, ".mcap"));
}

TEST(Numbered, OtherFilesHaveNone) {
  for (const char* const other :
       {"", "segment", "segment.", "segment..mcap", "segment.1.mcap", "segment.0000000x.mcap",
        "segment.00000001.mcap.new", "segments.00000001.mcap", "given.00000001",
        "segment.-0000001.mcap", "segment.99999999999999999999999.mcap"}) {
    EXPECT_FALSE(number_in(other, "segment", ".mcap")) << other;
  }
}

}  // namespace
}  // namespace tocsin::sample_log
