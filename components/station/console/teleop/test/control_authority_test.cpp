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
  EXPECT_EQ(control_text(GetParam().authority, "ben", {"h", "H", "n"}), GetParam().text);
}

INSTANTIATE_TEST_SUITE_P(
    All, ControlAuthorityTest,
    ::testing::Values(
        AuthorityCase{{"", ""}, {}, ""}, AuthorityCase{{"ben", ""}, {}, ""},
        AuthorityCase{
            {"anna", ""}, ControlVerb::ask, "anna drives: h asks for control, H takes it"},
        AuthorityCase{{"anna", "ben"},
                      ControlVerb::ask,
                      "anna drives, and was asked for control: H takes it"},
        AuthorityCase{
            {"anna", "carl"}, ControlVerb::ask, "anna drives: h asks for control, H takes it"},
        AuthorityCase{
            {"ben", "anna"}, ControlVerb::give, "anna asks for control: h gives, n keeps it"}));

TEST(ControlText, SaysNothingOfKeysThatTheDeviceLacks) {
  const ControlKeys pad{"start", "", ""};
  EXPECT_EQ(control_text({"anna", ""}, "ben", pad), "anna drives: start asks for control");
  EXPECT_EQ(control_text({"anna", "ben"}, "ben", pad), "anna drives, and was asked for control");
  EXPECT_EQ(control_text({"ben", "anna"}, "ben", pad), "anna asks for control: start gives");
}

TEST(OperatorName, IsTheGivenOneOrTellsComputerAndProcess) {
  EXPECT_EQ(operator_name("anna", "keyboard"), "anna");
  EXPECT_THAT(operator_name("", "keyboard"), ::testing::StartsWith("keyboard@"));
}

}  // namespace
}  // namespace tocsin
