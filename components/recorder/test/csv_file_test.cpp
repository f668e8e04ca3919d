// SPDX-License-Identifier: Apache-2.0
#include "recorder/csv_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "foundation/error.hpp"

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

TEST(CsvFile, SaysThatRowsAreLostAndGoesOn) {
  CsvFile sut("/dev/full", {"a"});
  sut.write({"1"});
  EXPECT_FALSE(sut.flush());
  EXPECT_TRUE(sut.write({"2"}));
  EXPECT_FALSE(sut.flush());
}

}  // namespace
}  // namespace tocsin
