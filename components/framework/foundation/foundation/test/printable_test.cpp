// SPDX-License-Identifier: Apache-2.0
#include "foundation/printable.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

using namespace std::string_literals;

TEST(Printable, LeavesOrdinaryTextAsItIs) {
  for (const char* text : {"", "uxv/location", R"(C:\map "a", 'b')", "Größe 5 µm, 地図, 🚗"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, EscapesControlCharacters) {
  EXPECT_EQ(printable("a\x1b[2Jb"), "a\\x1b[2Jb");
  EXPECT_EQ(printable("one\ntwo\r\n\tthree"), "one\\ntwo\\r\\n\\tthree");
  EXPECT_EQ(printable("a\0b\x7f"s), "a\\x00b\\x7f");
  EXPECT_EQ(printable("\xc2\x9b"), "\\x9b") << "the one-character start of an escape sequence";
}

TEST(Printable, EscapesWhatReordersOrHidesText) {
  EXPECT_EQ(printable("\xe2\x80\xae"
                      "a\xe2\x80\x8b\xe2\x80\xa8"),
            "\\u202ea\\u200b\\u2028");
}

TEST(Printable, EscapesBytesThatAreNotUtf8) {
  EXPECT_EQ(printable("a\xff\xfe"
                      "b"),
            "a\\xff\\xfeb");
  EXPECT_EQ(printable("cut \xe5\x9c"), "cut \\xe5\\x9c");
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf") << "longer than needed";
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a surrogate pair";
}

TEST(Printable, ShortensBehindTheLimitAndTellsTheSize) {
  EXPECT_EQ(printable("12345", 5), "12345");
  EXPECT_EQ(printable("123456", 5), "12345... (6 bytes)");
  EXPECT_EQ(printable(std::string(1U << 20U, 'a'), 3), "aaa... (1048576 bytes)");
}

TEST(Printable, ShortensAtTheBorderOfACharacter) {
  EXPECT_EQ(printable("地図地", 6), "地図... (9 bytes)");
  EXPECT_EQ(printable("地図地", 5), "地... (9 bytes)");
  EXPECT_EQ(printable("地図地", 1), "... (9 bytes)");
  EXPECT_EQ(printable("\x80\x80\x80\x80\x80\x80", 5), R"(\x80\x80\x80\x80\x80... (6 bytes))");
}

TEST(Printable, MakesNothingOfATextThatIsPrintableAlready) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    std::string noise(random() % 40, ' ');
    for (char& c : noise) c = static_cast<char>(random());
    const std::string once = printable(noise);
    ASSERT_EQ(printable(once, 1000), once);
    for (const char c : once) ASSERT_TRUE(static_cast<unsigned char>(c) >= ' ') << once;
  }
}

TEST(ErrorText, IsOneLineWhateverItQuotes) {
  EXPECT_STREQ(ConfigError("f.yaml: 'a\x1b[2J\n' is wrong").what(),
               "f.yaml: 'a\\x1b[2J\\n' is wrong");
  EXPECT_STREQ(EnvironmentError("wlan0\n").what(), "wlan0\\n");
  EXPECT_LT(std::string(ConfigError(std::string(1U << 20U, 'a')).what()).size(), 5000U);
}

TEST(CsvCell, QuotesAsRfc4180) {
  EXPECT_EQ(csv_cell("plain text"), "plain text");
  EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_cell("say \"no\""), "\"say \"\"no\"\"\"");
  EXPECT_EQ(csv_cell(""), "");
}

TEST(CsvCell, StaysOnOneLineAndWithinItsLimit) {
  EXPECT_EQ(csv_cell("a\n\x1b[31m,b"), "\"a\\n\\x1b[31m,b\"");
  EXPECT_EQ(csv_cell("aaaaa", 2), "aa... (5 bytes)");
}

TEST(NumberText, IsTheShortestThatReadsBack) {
  EXPECT_EQ(shortest_text(0.1), "0.1");
  EXPECT_EQ(shortest_text(-5), "-5");
  EXPECT_EQ(shortest_text(1e308), "1e+308");
  EXPECT_EQ(shortest_text(NAN), "nan");
  EXPECT_EQ(shortest_text(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(NumberText, IsFixedBelowABillionOnly) {
  EXPECT_EQ(fixed_text(1.005, 1), "1.0");
  EXPECT_EQ(fixed_text(-999'999'999, 2), "-999999999.00");
  EXPECT_EQ(fixed_text(1e9, 2), "1.00e+09");
  EXPECT_EQ(fixed_text(-1.2345e308, 2), "-1.23e+308");
  EXPECT_EQ(fixed_text(NAN, 2), "nan");
  EXPECT_EQ(fixed_text(std::numeric_limits<double>::infinity(), 2), "inf");
}

}  // namespace
}  // namespace tocsin
