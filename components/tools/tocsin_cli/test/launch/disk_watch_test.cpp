// SPDX-License-Identifier: Apache-2.0
#include "disk_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin::cli {
namespace {

using ::testing::HasSubstr;

constexpr std::uint64_t mib = 1U << 20U;

class DiskWatchTest : public ::testing::Test {
 protected:
  std::string look(std::optional<std::uint64_t> free_bytes) {
    return sut_.on_look(free_bytes).value_or("");
  }
  DiskWatch sut_{"/runs/a"};
};

TEST_F(DiskWatchTest, SaysOnceThatTheDiskIsFullAndOnceThatItIsOver) {
  EXPECT_EQ(look(mib), "");
  EXPECT_THAT(look(mib - 1), HasSubstr("DISK FULL: recordings and logs in /runs/a are lost"));
  EXPECT_EQ(look(0), "");
  EXPECT_EQ(look(2 * mib - 1), "");
  EXPECT_EQ(look(2 * mib), "the disk of /runs/a has room again");
  EXPECT_EQ(look(mib), "");
  EXPECT_THAT(look(0), HasSubstr("DISK FULL"));
}

TEST_F(DiskWatchTest, SaysOnceThatTheRunFolderIsGone) {
  EXPECT_THAT(look(std::nullopt), HasSubstr("RUN FOLDER GONE: /runs/a was removed"));
  EXPECT_EQ(look(std::nullopt), "");
  EXPECT_EQ(look(5 * mib), "/runs/a is there again");
}

}  // namespace
}  // namespace tocsin::cli
