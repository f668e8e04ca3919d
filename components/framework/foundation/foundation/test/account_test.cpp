// SPDX-License-Identifier: Apache-2.0
#include "foundation/account.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

constexpr uid_t without_name = 3'999'999'999;

TEST(Account, IsFoundByNameAndByNumber) {
  ASSERT_TRUE(find_account("root"));
  EXPECT_EQ(find_account("root")->id, 0U);
  EXPECT_EQ(find_account("0")->name, "root");
}

TEST(Account, ANumberWithoutANameHasTheGroupOfThatNumber) {
  const auto sut = find_account(std::to_string(without_name));
  ASSERT_TRUE(sut);
  EXPECT_EQ(sut->id, without_name);
  EXPECT_EQ(sut->group, without_name);
  EXPECT_EQ(to_string(*sut), "user 3999999999");
}

TEST(Account, WhatIsNobodysNameOrNumberIsNone) {
  for (const char* text : {"", "-1", "4294967295", "4294967296", "1.5", "nobody of this name"}) {
    EXPECT_FALSE(find_account(text)) << text;
  }
}

TEST(Account, TheFirstPathThatItMayNotUseIsTold) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can become another user";
  const TemporaryFolder folder;
  const std::string open = folder.write("open", "");
  const std::string closed = folder.write("closed", "");
  ASSERT_EQ(::chmod(folder.path().c_str(), 0755), 0);
  ASSERT_EQ(::chmod(open.c_str(), 0644), 0);
  ASSERT_EQ(::chmod(closed.c_str(), 0600), 0);
  const Account other{"", without_name, without_name};
  EXPECT_EQ(first_denied(other, {{open, R_OK}}), std::nullopt);
  EXPECT_EQ(first_denied(other, {{open, R_OK}, {closed, R_OK}, {open, W_OK}}), closed);
  EXPECT_EQ(first_denied(other, {{open, W_OK}}), open);
}

}  // namespace
}  // namespace tocsin
