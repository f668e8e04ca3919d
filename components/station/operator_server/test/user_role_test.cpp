// SPDX-License-Identifier: Apache-2.0
#include "operator_server/user_role.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin::foxglove {
namespace {

std::string fault_of(const std::string& text) {
  try {
    (void)parse_tokens("tokens", text, UserRole::driver);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

TEST(UserRoleTest, AFileHasATokenALineWithItsRole) {
  const auto sut = parse_tokens("tokens",
                                "# of the site\n"
                                "supervisor 0123456789abcdef\n\n"
                                "  observer\tfedcba9876543210\r\n"
                                "0123456789fedcba\n",
                                UserRole::driver);
  ASSERT_EQ(sut.size(), 3U);
  EXPECT_EQ(sut[0].role, UserRole::supervisor);
  EXPECT_EQ(sut[0].token, "0123456789abcdef");
  EXPECT_EQ(sut[1].role, UserRole::observer);
  EXPECT_EQ(sut[1].token, "fedcba9876543210");
  EXPECT_EQ(sut[2].role, UserRole::driver);
}

TEST(UserRoleTest, WhatIsNoTokenIsNamedWithItsLine) {
  EXPECT_EQ(fault_of(""), "tokens: has no token");
  EXPECT_EQ(fault_of("# nothing\n"), "tokens: has no token");
  EXPECT_EQ(fault_of("0123456789abcde"),
            "tokens:1: a token of 15 characters is too short; at least 16");
  EXPECT_EQ(fault_of("\nboss 0123456789abcdef"),
            "tokens:2: 'boss' is not one of: observer, operator, supervisor; a line is ROLE TOKEN "
            "or TOKEN");
  EXPECT_EQ(fault_of("observer 0123456789abcdef more"), "tokens:1: more than a role and a token");
  EXPECT_EQ(fault_of("observer 0123456789abcdef\nsupervisor 0123456789abcdef"),
            "tokens:2: this token is there already");
}

}  // namespace
}  // namespace tocsin::foxglove
