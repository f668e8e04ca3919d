// SPDX-License-Identifier: Apache-2.0
#include "csv_tables/csv_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "foundation/error.hpp"
#include "foundation/small_disk.hpp"

namespace tocsin {
namespace {

class CsvFileTest : public ::testing::Test {
 protected:
  ~CsvFileTest() override { unlink(path_.c_str()); }
  [[nodiscard]] std::string text() const {
    std::ostringstream read;
    read << std::ifstream(path_).rdbuf();
    return read.str();
  }
  const std::string path_ = ::testing::TempDir() + "csv_file_" + std::to_string(getpid());
};

TEST_F(CsvFileTest, WritesTheHeaderOnce) {
  CsvFile(path_, {"a", "b"}).write({"1", "2"});
  CsvFile(path_, {"a", "b"}).write({"3", "x,y"});
  EXPECT_EQ(text(), "a,b\n1,2\n3,\"x,y\"\n");
}

TEST_F(CsvFileTest, RefusesAFileThatCannotBeOpened) {
  EXPECT_THROW(CsvFile("/proc/nothing.csv", {"a"}), ConfigError);
}

TEST_F(CsvFileTest, FlushesByItselfWhenManyRowsWait) {
  CsvFile sut(path_, {"a"});
  sut.write({std::string(60000, 'x')});
  EXPECT_EQ(text(), "");
  sut.write({std::string(6000, 'x')});
  EXPECT_EQ(text().size(), 66004U);
}

TEST(CsvFile, CountsTheRowsThatAFullDiskTakesAndGoesOn) {
  CsvFile sut("/dev/full", {"a"});
  sut.write({"1"});
  EXPECT_FALSE(sut.flush());
  EXPECT_EQ(sut.lost(), 2U);  // the names of the columns, too
  sut.write({"2"});
  EXPECT_FALSE(sut.flush());
  EXPECT_EQ(sut.lost(), 3U);
}

TEST_F(CsvFileTest, ARowThatWasCutIsEndedAndNoneComesTwice) {
  CsvFile sut(path_, {"a"});
  sut.write({"first"});
  ASSERT_TRUE(sut.flush());
  {
    const SmallDisk disk(text().size() + 9);
    for (const char* row : {"second", "third", "fourth"}) sut.write({row});
    EXPECT_FALSE(sut.flush());
    EXPECT_EQ(sut.lost(), 2U);
    sut.write({"fifth"});
    EXPECT_FALSE(sut.flush());
    EXPECT_EQ(sut.lost(), 3U);
  }
  sut.write({"sixth"});
  EXPECT_TRUE(sut.flush());
  EXPECT_EQ(text(), "a\nfirst\nsecond\nth\nsixth\n");
  EXPECT_EQ(sut.lost(), 3U);
}

}  // namespace
}  // namespace tocsin
