// SPDX-License-Identifier: Apache-2.0
#include "line_splitter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(LineSplitter, CutsAtLineEnds) {
  LineSplitter sut;
  EXPECT_THAT(sut.feed("one\ntwo\n"), ElementsAre("one", "two"));
  EXPECT_EQ(sut.rest(), "");
}

TEST(LineSplitter, JoinsPiecesOfALine) {
  LineSplitter sut;
  EXPECT_THAT(sut.feed("on"), IsEmpty());
  EXPECT_THAT(sut.feed("e\ntw"), ElementsAre("one"));
  EXPECT_THAT(sut.feed("o\n"), ElementsAre("two"));
}

TEST(LineSplitter, HandsOutTheUnfinishedLineOnce) {
  LineSplitter sut;
  (void)sut.feed("a\nlast words");
  EXPECT_EQ(sut.rest(), "last words");
  EXPECT_EQ(sut.rest(), "");
}

TEST(LineSplitter, CutsLinesOfMoreThan8192Bytes) {
  LineSplitter sut;
  EXPECT_THAT(sut.feed(std::string(8191, 'x')), IsEmpty());
  EXPECT_THAT(sut.feed("x"), ElementsAre(std::string(8192, 'x')));
  EXPECT_THAT(sut.feed("y\n"), ElementsAre("y"));
}

}  // namespace
}  // namespace tocsin::cli
