// SPDX-License-Identifier: Apache-2.0
#include "terminal/aged.hpp"

#include <gtest/gtest.h>

namespace tocsin::terminal {
namespace {

const Line words{{"12 %", Style::bad}, {", well", Style::good, 2}};

std::string text_of(double age_s, bool colour = false) {
  return to_text(aged(words, seconds(age_s)), 80, colour);
}

TEST(Aged, AFreshValueStaysAsItIs) {
  EXPECT_EQ(text_of(3), "12 %, well");
  EXPECT_EQ(text_of(3, true), to_text(words, 80, true));
}

TEST(Aged, AStaleValueIsGreyAndTellsItsAge) {
  EXPECT_EQ(text_of(3.001), "12 %, well, 3 s ago");
  for (const Span& span : aged(words, seconds(30))) EXPECT_EQ(span.style, Style::old);
}

TEST(Aged, OfAnUnknownValueOnlyTheAgeIsLeft) {
  EXPECT_EQ(text_of(30), "12 %, well, 30 s ago");
  EXPECT_EQ(text_of(180), "unknown for 3 min");
}

}  // namespace
}  // namespace tocsin::terminal
