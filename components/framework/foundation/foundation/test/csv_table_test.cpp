// SPDX-License-Identifier: Apache-2.0
#include "foundation/csv_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;

TEST(CsvNumber, IsNanForWhatIsNotWhollyANumber) {
  EXPECT_EQ(csv_number("-2.5e1"), -25);
  for (const char* text : {"", "x", "3x", "1,5"}) EXPECT_TRUE(std::isnan(csv_number(text))) << text;
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

TEST(CsvReader, TellsTheLineAtWhichARowBegins) {
  CsvReader sut("a\n\n\"two\nlines\",x\r\nlast");
  EXPECT_EQ(sut.next()->line, 1U);
  EXPECT_THAT(sut.next()->cells, ElementsAre(""));
  EXPECT_EQ(sut.next()->line, 3U);
  const auto last = sut.next();
  EXPECT_EQ(last->line, 5U);
  EXPECT_THAT(last->cells, ElementsAre("last"));
  EXPECT_FALSE(sut.next());
}

TEST(CsvReader, AnEmptyCellAtTheEndIsACell) {
  EXPECT_THAT(CsvReader("1,,").next()->cells, ElementsAre("1", "", ""));
}

class CsvFileOfAPersonTest : public ::testing::Test {
 protected:
  CsvTable load(const std::string& text) { return CsvTable::load(folder_.write("a.csv", text)); }
  template <class Function>
  static std::string error_when(const Function& function) {
    try {
      function();
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  std::string error_of(const std::string& text) {
    return error_when([&] { (void)load(text); });
  }
  TemporaryFolder folder_;
};

TEST_F(CsvFileOfAPersonTest, MustBeThere) {
  EXPECT_THAT(error_when([] { (void)CsvTable::load("/no/such/file"); }),
              HasSubstr("/no/such/file"));
  EXPECT_THAT(error_when([&] { (void)CsvTable::load(folder_.path()); }),
              HasSubstr("cannot be read"));
}

TEST_F(CsvFileOfAPersonTest, MustHaveRows) {
  EXPECT_THAT(error_of(""), EndsWith("a.csv: is empty, must be CSV"));
  EXPECT_THAT(error_of("a,b\n \n"), EndsWith("a.csv: has no row besides the first"));
}

TEST_F(CsvFileOfAPersonTest, HasRowsOfOneLength) {
  EXPECT_THAT(error_of("a,b\n1,2\n\n3\n"),
              EndsWith("a.csv:4: 1 cells, must be 2 as in the first row"));
}

TEST_F(CsvFileOfAPersonTest, GivesColumnsWithoutSpacesAround) {
  const CsvTable sut = load("a, b\r\n 1 ,x\r\nnan, y z\r\n");
  EXPECT_THAT(sut.columns(), ElementsAre("a", "b"));
  EXPECT_THAT(sut.texts("b"), ElementsAre("x", "y z"));
  const std::vector<double> numbers = sut.numbers("a");
  EXPECT_EQ(numbers[0], 1);
  EXPECT_TRUE(std::isnan(numbers[1]));
}

TEST_F(CsvFileOfAPersonTest, NamesPlaceAndTextOfWhatIsNoNumber) {
  const CsvTable sut = load("a,b\n1,2\n3,4x\n");
  EXPECT_THAT(error_when([&] { (void)sut.numbers("b"); }),
              EndsWith("a.csv:3: b: '4x' is not a number"));
  EXPECT_THAT(error_when([&] { (void)sut.numbers("c"); }),
              EndsWith("has no column 'c', has: a, b"));
}

TEST_F(CsvFileOfAPersonTest, KeepsTheRowsThatAreWanted) {
  CsvTable sut = load("a\n1\n2\n3\n");
  sut.keep({true, false, true});
  EXPECT_THAT(sut.texts("a"), ElementsAre("1", "3"));
  EXPECT_THAT(error_when([&] { sut.reject(1, "a", "too many"); }),
              EndsWith("a.csv:4: a: too many"));
}

}  // namespace
}  // namespace tocsin
