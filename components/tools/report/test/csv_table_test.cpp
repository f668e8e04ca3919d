// SPDX-License-Identifier: Apache-2.0
#include "report/csv_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tocsin::report {
namespace {

TEST(NumberOf, IsNanForWhatIsNotWhollyANumber) {
  EXPECT_EQ(number_of("-2.5e1"), -25);
  for (const char* text : {"", "x", "3x", "1,5"}) EXPECT_TRUE(std::isnan(number_of(text))) << text;
}

TEST(CsvTable, NamesColumnsByTheFirstRow) {
  const CsvTable sut("a,b\n1,x\n2,y\n");
  ASSERT_EQ(sut.rows(), 2U);
  EXPECT_EQ(sut.text(1, "b"), "y");
  EXPECT_EQ(sut.number(0, "a"), 1);
  EXPECT_TRUE(sut.has("a"));
  EXPECT_FALSE(sut.has("c"));
}

TEST(CsvTable, ReadsQuotedCells) {
  const CsvTable sut("a,b\n\"one, two\",\"say \"\"hi\"\"\"\n\"line\nbreak\",\"\"\n");
  ASSERT_EQ(sut.rows(), 2U);
  EXPECT_EQ(sut.text(0, "a"), "one, two");
  EXPECT_EQ(sut.text(0, "b"), "say \"hi\"");
  EXPECT_EQ(sut.text(1, "a"), "line\nbreak");
  EXPECT_EQ(sut.text(1, "b"), "");
}

TEST(CsvTable, TakesLineEndsOfBothKinds) {
  const CsvTable sut("a,b\r\n1,2\r\n3,4");
  ASSERT_EQ(sut.rows(), 2U);
  EXPECT_EQ(sut.text(1, "b"), "4");
}

TEST(CsvTable, LeavesOutRowsOfAnotherLength) {
  const CsvTable sut("a,b\n1,2\n3\n4,5,6\n\n7,8\n");
  EXPECT_EQ(sut.rows(), 2U);
  EXPECT_EQ(sut.bad_rows(), 2U);
  EXPECT_EQ(sut.text(1, "a"), "7");
}

TEST(CsvTable, SurvivesAQuoteThatNeverEnds) {
  const CsvTable sut("a,b\n1,\"x");
  ASSERT_EQ(sut.rows(), 1U);
  EXPECT_EQ(sut.text(0, "b"), "x");
}

TEST(CsvTable, HasNoNumberWhereThereIsNone) {
  const CsvTable sut("a,b,c\n,x,1x\n");
  EXPECT_TRUE(std::isnan(sut.number(0, "a")));
  EXPECT_TRUE(std::isnan(sut.number(0, "b")));
  EXPECT_TRUE(std::isnan(sut.number(0, "c")));
  EXPECT_TRUE(std::isnan(sut.number(0, "no_such_column")));
}

TEST(CsvTable, IsEmptyForAnAbsentFile) { EXPECT_EQ(CsvTable::read("/no/such/file").rows(), 0U); }

}  // namespace
}  // namespace tocsin::report
