// SPDX-License-Identifier: Apache-2.0
#include "telemetry/words.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace tocsin::telemetry {
namespace {

TEST(TakeLine, TakesOneAfterTheOther) {
  std::string_view sut = "one two\n\nthree";
  EXPECT_EQ(take_line(sut), "one two");
  EXPECT_EQ(take_line(sut), "");
  EXPECT_EQ(sut, "three");
  EXPECT_EQ(take_line(sut), "three");
  EXPECT_TRUE(sut.empty());
  EXPECT_EQ(take_line(sut), "");
}

TEST(TakeWord, TakesOneAfterTheOther) {
  std::string_view sut = "  one\ttwo \n ";
  EXPECT_EQ(take_word(sut), "one");
  EXPECT_EQ(take_word(sut), "two");
  EXPECT_EQ(take_word(sut), "");
  EXPECT_TRUE(sut.empty());
  EXPECT_EQ(take_word(sut), "");
}

TEST(WholeNumber, IsTheWholeWordInTheRangeOfItsType) {
  EXPECT_EQ(whole_number<int>("12"), 12);
  EXPECT_EQ(whole_number<int>("-12"), -12);
  for (const char* none : {"12 ", " 12", "12x", "x", ""}) EXPECT_FALSE(whole_number<int>(none));
  EXPECT_EQ(whole_number<std::uint64_t>("18446744073709551615"), UINT64_MAX);
  EXPECT_FALSE(whole_number<std::uint64_t>("18446744073709551616"));
  EXPECT_FALSE(whole_number<std::uint64_t>("-1"));
}

}  // namespace
}  // namespace tocsin::telemetry
