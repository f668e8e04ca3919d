// SPDX-License-Identifier: Apache-2.0
// What holds for the files of a folder and for those in memory.
#include "sample_log/log_files.hpp"

#include <gmock/gmock.h>

#include <memory>
#include <string>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::sample_log {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::vector<std::uint8_t> text{'a', 'b', 'c'};

class EachKindOfFiles : public ::testing::TestWithParam<bool> {
 protected:
  EachKindOfFiles() {
    if (GetParam()) {
      files_ = std::make_unique<FolderFiles>(folder_.path("a/log"));
    } else {
      files_ = std::make_unique<MemoryFiles>();
    }
  }
  [[nodiscard]] std::string text_of(const std::string& name) const {
    const auto source = files_->open(name);
    std::vector<std::uint8_t> bytes(source->size());
    EXPECT_TRUE(source->read(0, bytes.data(), bytes.size()));
    return {bytes.begin(), bytes.end()};
  }
  TemporaryFolder folder_;
  std::unique_ptr<LogFiles> files_;
};

TEST_P(EachKindOfFiles, AreReadAsTheyWereAppended) {
  const auto file = files_->make("one");
  EXPECT_EQ(file->append({{text.data(), 3}}), mcap::Kept::all);
  EXPECT_EQ(text_of("one"), "abc") << "also while it is written";
  EXPECT_EQ(file->append({{text.data(), 1}, {text.data(), 2}}), mcap::Kept::all);
  file->sync();
  EXPECT_EQ(text_of("one"), "abcaab");
}

TEST_P(EachKindOfFiles, AreMadeOnceAndReadOnlyWhenTheyAreThere) {
  (void)files_->make("one");
  EXPECT_THROW((void)files_->make("one"), ConfigError);
  EXPECT_THROW((void)files_->open("two"), ConfigError);
}

INSTANTIATE_TEST_SUITE_P(Files, EachKindOfFiles, ::testing::Bool(), [](const auto& which) {
  return std::string(which.param ? "InAFolder" : "InMemory");
});

TEST(FolderFiles, RefuseAFolderThatAnotherLogHas) {
  const TemporaryFolder folder;
  const FolderFiles first(folder.path("log"));
  EXPECT_THROW(FolderFiles(folder.path("log")), ConfigError);
}

TEST(MemoryFiles, TakeNothingBeyondTheirRoom) {
  MemoryFiles files;
  const auto file = files.make("one");
  files.room = 5;
  EXPECT_EQ(file->append({{text.data(), 3}}), mcap::Kept::all);
  EXPECT_EQ(file->append({{text.data(), 3}}), mcap::Kept::nothing);
  EXPECT_EQ(file->append({{text.data(), 2}}), mcap::Kept::all);
  EXPECT_EQ(files.size(), 5U);
}

}  // namespace
}  // namespace tocsin::sample_log
