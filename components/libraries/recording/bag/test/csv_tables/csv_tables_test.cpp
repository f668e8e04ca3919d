// SPDX-License-Identifier: Apache-2.0
#include "csv_tables/csv_tables.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "ros_idl/std_msgs.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class CsvTablesTest : public ::testing::Test {
 protected:
  void write(CsvTables& sut, const std::string& topic, const std::string& text) const {
    std_msgs::msg::String message;
    message.data(text);
    sut.write({topic, 2'000'000'000, 1'000'000'000, 9, 4, 14}, &type_info<std_msgs::msg::String>(),
              &message);
  }
  const TemporaryFolder folder_;
};

TEST_F(CsvTablesTest, ATopicHasItsOwnFileFromItsFirstMessageOn) {
  CsvTables sut(folder_.path("deep/er"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path("deep/er/a.b.csv")));
  write(sut, "a/b", "hello");
  EXPECT_EQ(folder_.read("deep/er/a.b.csv"),
            "receive_s,send_s,sequence,data\n2.000000000,1.000000000,4,hello\n");
  EXPECT_THAT(folder_.read("deep/er/messages.csv"), HasSubstr(",a/b,9,4,14\n"));
  EXPECT_EQ(sut.lost(), 0U);
}

TEST_F(CsvTablesTest, AFileThatCannotBeMadeCostsItsRowsOnly) {
  std::filesystem::create_directory(folder_.path("a.csv"));
  CsvTables sut(folder_.path());
  write(sut, "a", "1");
  write(sut, "b", "2");
  EXPECT_THAT(sut.take_problems(), ElementsAre(HasSubstr("a.csv")));
  EXPECT_THAT(sut.take_problems(), IsEmpty());
  EXPECT_THAT(folder_.read("b.csv"), HasSubstr(",2\n"));
}

TEST_F(CsvTablesTest, CountsWhatAFullDiskTakes) {
  std::filesystem::create_symlink("/dev/full", folder_.path("a.csv"));
  CsvTables sut(folder_.path());
  write(sut, "a", "1");
  write(sut, "b", "2");
  EXPECT_EQ(sut.lost(), 2U) << "the names of the columns, too";
  EXPECT_THAT(folder_.read("b.csv"), HasSubstr(",2\n"));
}

TEST_F(CsvTablesTest, AFolderThatCannotBeMadeIsNamed) {
  (void)folder_.write("file", "");
  try {
    const CsvTables sut(folder_.path("file/csv"));
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("file/csv cannot be made"));
  }
}

}  // namespace
}  // namespace tocsin
