// SPDX-License-Identifier: Apache-2.0
#include "terminal/line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin::terminal {
namespace {

using ::testing::ElementsAre;

std::string plain(const Line& line, std::size_t width) { return to_text(line, width, false); }

TEST(Line, LeavesOutTheHighestRankFirst) {
  const Line line{
      {"aa"}, {"bb", Style::plain, 1}, {"cc", Style::plain, 3}, {"dd", Style::plain, 2}};
  EXPECT_EQ(plain(line, 8), "aabbccdd");
  EXPECT_EQ(plain(line, 7), "aabbdd");
  EXPECT_EQ(plain(line, 5), "aabb");
  EXPECT_EQ(plain(line, 3), "aa");
}

TEST(Line, LeavesOutTheRightmostAmongEqualRanks) {
  const Line line{{"aa", Style::plain, 1}, {"bb", Style::plain, 1}, {"cc", Style::plain, 1}};
  EXPECT_EQ(plain(line, 4), "aabb");
}

TEST(Line, CutsWhatMayNotBeLeftOut) {
  EXPECT_EQ(plain({{"abc"}, {"def"}}, 5), "abcd>");
  EXPECT_EQ(plain({{"abc"}, {"def"}}, 4), "abc>");
  EXPECT_EQ(plain({{"abc"}, {"def"}}, 3), "ab>") << "the mark says that def follows";
  EXPECT_EQ(plain({{"abc"}, {"def"}}, 1), ">");
  EXPECT_EQ(plain({{"abc"}, {"def"}}, 0), "");
}

TEST(Line, ColoursTakeNoRoom) {
  const Line line{{"abc", Style::bad}, {"def", Style::old}};
  EXPECT_EQ(to_text(line, 6, true), "\x1b[31mabc\x1b[0m\x1b[2mdef\x1b[0m");
  EXPECT_EQ(plain(line, 6), "abcdef");
}

TEST(Line, MakesTextOfOthersPrintable) { EXPECT_EQ(plain({{"a\x1b[2J"}}, 20), "a\\x1b[2J"); }

std::vector<std::string> texts(const Table& table, std::size_t width) {
  std::vector<std::string> all;
  for (const Line& line : table.lines(width)) all.push_back(plain(line, width));
  return all;
}

Table table_of_three() {
  Table table({{"name"}, {"note", Align::left, 1}, {"n", Align::right}});
  table.add({{"long_name"}, {"x"}, {"1"}});
  table.add({{"b"}, {"yy"}, {"200"}});
  return table;
}

TEST(Table, GivesUpColumnsByRank) {
  EXPECT_THAT(texts(table_of_three(), 17), ElementsAre("name        n",  //
                                                       "long_name   1",  //
                                                       "b         200"));
}

TEST(Table, CutsItsFirstColumnThen) {
  EXPECT_THAT(texts(table_of_three(), 12), ElementsAre("name       n",  //
                                                       "long_na>   1",  //
                                                       "b        200"));
}

TEST(Table, AnotherColumnMayBeTheElasticOne) {
  Table table({{"level"}, {"name"}, {"n"}}, 1);
  table.add({{"ERROR"}, {"a_long_name"}, {"1"}});
  EXPECT_THAT(texts(table, 17), ElementsAre("level name      n", "ERROR a_long_n> 1"));
}

TEST(Table, CutsItsLinesWhenNothingElseIsLeft) {
  for (std::size_t width = 0; width < 12; ++width) {
    for (const std::string& line : texts(table_of_three(), width)) {
      EXPECT_LE(width_of(line), width) << line;
    }
  }
}

}  // namespace
}  // namespace tocsin::terminal
