// SPDX-License-Identifier: Apache-2.0
#include "foundation/replace_file.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;

/// As long as it lives, no file of this process grows beyond so many bytes: the kernel takes a part
/// of a write, as of a disk that becomes full in its middle.
class RoomFor {
 public:
  explicit RoomFor(rlim_t bytes) : handler_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~RoomFor() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, handler_);
  }
  RoomFor(const RoomFor&) = delete;
  RoomFor& operator=(const RoomFor&) = delete;

 private:
  rlimit before_{};
  sighandler_t handler_;
};

class ReplaceFileTest : public ::testing::TestWithParam<Sync> {
 protected:
  const TemporaryFolder folder_;
  const std::string file_ = folder_.path("pids.json");
};

TEST_P(ReplaceFileTest, PutsTheNewTextInThePlaceOfTheOldOne) {
  EXPECT_FALSE(replace_file(file_, "first", GetParam()));
  EXPECT_FALSE(replace_file(file_, "second", GetParam()));
  EXPECT_EQ(folder_.read("pids.json"), "second");
  EXPECT_FALSE(fs::exists(file_ + ".new"));
}

TEST_P(ReplaceFileTest, WritesToADeviceAndLeavesItsName) {
  fs::create_symlink("/dev/null", file_);
  EXPECT_FALSE(replace_file(file_, "text", GetParam()));
  EXPECT_TRUE(fs::is_symlink(file_));
  fs::remove(file_);
  fs::create_symlink("/dev/full", file_);
  EXPECT_TRUE(is_disk_full(replace_file(file_, "text", GetParam())));
  EXPECT_TRUE(fs::is_symlink(file_));
}

TEST_P(ReplaceFileTest, KeepsTheOldTextWhenOnlyAPartOfTheNewOneFits) {
  folder_.write("pids.json", "good");
  std::error_code error;
  {
    const RoomFor room(100);
    error = replace_file(file_, std::string(101, 'x'), GetParam());
  }
  EXPECT_EQ(error.value(), EFBIG);
  EXPECT_EQ(folder_.read("pids.json"), "good");
  EXPECT_FALSE(fs::exists(file_ + ".new"));
}

TEST_P(ReplaceFileTest, TakesATextThatJustFits) {
  {
    const RoomFor room(100);
    EXPECT_FALSE(replace_file(file_, std::string(100, 'x'), GetParam()));
  }
  EXPECT_EQ(folder_.read("pids.json").size(), 100U);
}

TEST_P(ReplaceFileTest, SaysWhyWhenTheFolderIsGone) {
  const std::error_code error = replace_file(folder_.path("gone/file"), "text", GetParam());
  EXPECT_EQ(error, std::errc::no_such_file_or_directory);
  EXPECT_FALSE(is_disk_full(error));
}

INSTANTIATE_TEST_SUITE_P(WithAndWithout, ReplaceFileTest, ::testing::Values(Sync::yes, Sync::no));

TEST(DiskFull, IsALackOfRoomOrASpentQuota) {
  EXPECT_TRUE(is_disk_full({ENOSPC, std::generic_category()}));
  EXPECT_TRUE(is_disk_full({EDQUOT, std::generic_category()}));
  EXPECT_FALSE(is_disk_full({EACCES, std::generic_category()}));
  EXPECT_FALSE(is_disk_full({}));
}

}  // namespace
}  // namespace tocsin
