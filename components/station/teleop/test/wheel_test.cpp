// SPDX-License-Identifier: Apache-2.0
#include "teleop_sender/wheel.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin {
namespace {

using ::testing::StartsWith;

TEST(HandoverVerb, AsksWhoDrivesAndGivesToWhoAsks) {
  EXPECT_EQ(handover_verb({"anna", ""}, "ben"), "ask");
  EXPECT_EQ(handover_verb({"anna", "ben"}, "anna"), "give");
}

TEST(HandoverVerb, IsNothingWithoutSomebodyToAskOrToGiveTo) {
  EXPECT_FALSE(handover_verb({}, "ben"));
  EXPECT_FALSE(handover_verb({"ben", ""}, "ben"));
}

TEST(WheelText, TellsWhatConcernsTheOperator) {
  EXPECT_EQ(wheel_text({}, "ben"), "");
  EXPECT_EQ(wheel_text({"ben", ""}, "ben"), "");
  EXPECT_EQ(wheel_text({"anna", ""}, "ben"), "anna drives: h asks for the wheel");
  EXPECT_EQ(wheel_text({"anna", "ben"}, "ben"), "anna drives, and was asked for the wheel");
  EXPECT_EQ(wheel_text({"anna", "carl"}, "ben"), "anna drives: h asks for the wheel");
  EXPECT_EQ(wheel_text({"ben", "anna"}, "ben"), "anna asks for the wheel: h gives, n keeps it");
}

TEST(OperatorName, IsTheGivenOneOrTellsComputerAndProcess) {
  EXPECT_EQ(operator_name("anna", "keyboard"), "anna");
  EXPECT_THAT(operator_name("", "keyboard"), StartsWith("keyboard@"));
  EXPECT_EQ(operator_name("", "keyboard"), operator_name("", "keyboard"));
}

}  // namespace
}  // namespace tocsin
