// SPDX-License-Identifier: Apache-2.0
#include "foundation/role.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

TEST(Role, EachHasAWordThatNamesIt) {
  for (const Role role : roles) EXPECT_EQ(role_of(to_string(role)), role);
  EXPECT_STREQ(to_string(Role::uxv), "uxv");
  EXPECT_STREQ(to_string(Role::gcs), "gcs");
}

TEST(Role, AnotherWordIsNone) {
  for (const char* word : {"", "UXV", "uxv2", "boat"}) EXPECT_FALSE(role_of(word)) << word;
}

}  // namespace
}  // namespace tocsin
