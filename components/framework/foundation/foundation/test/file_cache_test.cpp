// SPDX-License-Identifier: Apache-2.0
#include "foundation/file_cache.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;

class FileCacheTest : public ::testing::Test {
 protected:
  /// Writes the file, as if that had been so long ago.
  void write(const std::string& text, std::chrono::milliseconds ago) {
    path_ = folder_.write("file", text);
    std::filesystem::last_write_time(path_, now_ - ago);
  }
  int get() {
    return sut_.get(path_, [this] { return ++reads_; });
  }
  TemporaryFolder folder_;
  std::string path_;
  std::filesystem::file_time_type now_ = std::filesystem::file_time_type::clock::now();
  FileCache<int> sut_;
  int reads_ = 0;
};

TEST_F(FileCacheTest, ReadsAFileOnceThatDoesNotChange) {
  write("one", seconds(100));
  EXPECT_EQ(get(), 1);
  EXPECT_EQ(get(), 1);
}

TEST_F(FileCacheTest, ReadsAgainWhenTheTimeHasChanged) {
  write("one", seconds(100));
  EXPECT_EQ(get(), 1);
  write("two", seconds(99));
  EXPECT_EQ(get(), 2);
  EXPECT_EQ(get(), 2);
}

TEST_F(FileCacheTest, ReadsAgainWhenTheSizeHasChanged) {
  write("one", seconds(100));
  EXPECT_EQ(get(), 1);
  write("three", seconds(100));
  EXPECT_EQ(get(), 2);
}

TEST_F(FileCacheTest, ReadsAFreshFileEachTime) {
  write("one", seconds(1));
  EXPECT_EQ(get(), 1);
  EXPECT_EQ(get(), 2);
}

TEST_F(FileCacheTest, LeavesTheAnswerForAMissingFileToTheReader) {
  path_ = "/nowhere/file";
  EXPECT_THROW((void)sut_.get(path_, []() -> int { throw ConfigError("no file"); }), ConfigError);
  EXPECT_EQ(get(), 1);
  EXPECT_EQ(get(), 2);
}

TEST_F(FileCacheTest, KeepsNothingOfAFileThatCouldNotBeRead) {
  write("one", seconds(100));
  EXPECT_THROW((void)sut_.get(path_, []() -> int { throw ConfigError("bad"); }), ConfigError);
  EXPECT_EQ(get(), 1);
}

}  // namespace
}  // namespace tocsin
