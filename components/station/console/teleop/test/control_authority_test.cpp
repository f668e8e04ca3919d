// SPDX-License-Identifier: Apache-2.0
#include "teleop/control_authority.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin {
namespace {

struct AuthorityCase {
  ControlAuthority authority;
  std::optional<ControlVerb> verb;  ///< of Ben's key
  const char* text;                 ///< for Ben
};

class ControlAuthorityTest : public ::testing::TestWithParam<AuthorityCase> {};

TEST_P(ControlAuthorityTest, GivesOneKeyItsMeaningAndTheOperatorALine) {
  EXPECT_EQ(handover_verb(GetParam().authority, "ben"), GetParam().verb);
  EXPECT_EQ(control_text(GetParam().authority, "ben"), GetParam().text);
}

INSTANTIATE_TEST_SUITE_P(
    All, ControlAuthorityTest,
    ::testing::Values(
        AuthorityCase{{"", ""}, {}, ""}, AuthorityCase{{"ben", ""}, {}, ""},
        AuthorityCase{{"anna", ""}, ControlVerb::ask, "anna drives: h asks for control"},
        AuthorityCase{{"anna", "ben"}, ControlVerb::ask, "anna drives, and was asked for control"},
        AuthorityCase{{"anna", "carl"}, ControlVerb::ask, "anna drives: h asks for control"},
        AuthorityCase{
            {"ben", "anna"}, ControlVerb::give, "anna asks for control: h gives, n keeps it"}));

TEST(OperatorName, IsTheGivenOneOrTellsComputerAndProcess) {
  EXPECT_EQ(operator_name("anna", "keyboard"), "anna");
  EXPECT_THAT(operator_name("", "keyboard"), ::testing::StartsWith("keyboard@"));
}

}  // namespace
}  // namespace tocsin
