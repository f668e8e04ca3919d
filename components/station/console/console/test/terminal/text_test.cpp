// SPDX-License-Identifier: Apache-2.0
#include "terminal/text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <clocale>
#include <random>

namespace tocsin::terminal {
namespace {

TEST(WidthOf, CountsColumnsNotBytes) {
  EXPECT_EQ(width_of(""), 0U);
  EXPECT_EQ(width_of("abc"), 3U);
  EXPECT_EQ(width_of("Größe"), 5U);
  EXPECT_EQ(width_of("地図"), 4U);
  EXPECT_EQ(width_of("🚗"), 2U);
  EXPECT_EQ(width_of("e\xcc\x81"), 1U) << "with a combining accent";
}

TEST(WidthOf, CountsBytesThatAreNotUtf8AsOneEach) {
  EXPECT_EQ(width_of("a\xff\xfe"), 3U);
  EXPECT_EQ(width_of("\xe5\x9c"), 2U) << "a character that is cut";
  EXPECT_EQ(width_of(std::string_view("a\0b", 3)), 3U);
}

TEST(Cut, NeverSplitsACharacter) {
  EXPECT_EQ(cut("地図地", 5), "地図>");
  EXPECT_EQ(cut("地図地", 4), "地>");
  EXPECT_EQ(cut("地図地", 2), ">");
  EXPECT_EQ(cut("e\xcc\x81xyz", 2), "e\xcc\x81>");
}

TEST(Padded, FillsUpToTheWidth) {
  EXPECT_EQ(padded("ab", 4, Align::left), "ab  ");
  EXPECT_EQ(padded("ab", 4, Align::right), "  ab");
  EXPECT_EQ(padded("地", 4, Align::right), "  地");
  EXPECT_EQ(padded("abcdef", 4, Align::left), "abc>");
  EXPECT_EQ(padded("地図地", 4, Align::left), "地> ");
}

/// Texts of letters, wide and combining characters and bytes that are no UTF-8.
class RandomTexts {
 public:
  std::string next() {
    constexpr std::array pieces{"a", "ö", "地", "🚗", "e\xcc\x81", "\xff", "\xe5\x9c", ">"};
    std::string text;
    const std::size_t length = random_() % 12;
    for (std::size_t i = 0; i < length; ++i) text += pieces[random_() % pieces.size()];
    return text;
  }

 private:
  std::minstd_rand random_{1};
};

TEST(Cut, NeverTakesMoreRoomThanThereIsAndKeepsABeginning) {
  RandomTexts texts;
  for (int i = 0; i < 2000; ++i) {
    const std::string text = texts.next();
    for (std::size_t width = 0; width < 14; ++width) {
      const std::string shown = cut(text, width);
      ASSERT_LE(width_of(shown), width) << text;
      if (width_of(text) <= width) {
        ASSERT_EQ(shown, text);
      } else if (width > 0) {
        ASSERT_EQ(shown.back(), '>') << text;
        ASSERT_EQ(text.compare(0, shown.size() - 1, shown, 0, shown.size() - 1), 0) << text;
      }
    }
  }
}

TEST(Padded, TakesExactlyTheRoomThatThereIs) {
  RandomTexts texts;
  for (int i = 0; i < 2000; ++i) {
    const std::string text = texts.next();
    for (std::size_t width = 0; width < 14; ++width) {
      ASSERT_EQ(width_of(padded(text, width, Align::left)), width) << text;
      ASSERT_EQ(width_of(padded(text, width, Align::right)), width) << text;
    }
  }
}

}  // namespace
}  // namespace tocsin::terminal
