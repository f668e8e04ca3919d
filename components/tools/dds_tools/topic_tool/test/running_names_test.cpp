// SPDX-License-Identifier: Apache-2.0
#include "running_names.hpp"

#include <gtest/gtest.h>

namespace tocsin::topic_tool {
namespace {

TEST(SuggestedNames, AreThoseThatDifferByTwoLettersAtMost) {
  EXPECT_EQ(suggested_names({"/odom", "/scan"}, "/odomm"), "; did you mean '/odom'?");
  EXPECT_EQ(suggested_names({"/navigator"}, "/navgatro"), "; did you mean '/navigator'?");
  EXPECT_EQ(suggested_names({"/navigator"}, "/navgtro"), "");
}

TEST(SuggestedNames, OfAnotherNamespaceAreFoundByTheirLastWord) {
  EXPECT_EQ(suggested_names({"/uxv/odom", "/gcs/odom"}, "/odom"),
            "; did you mean '/gcs/odom' or '/uxv/odom'?");
  EXPECT_EQ(suggested_names({"/uxv/navigator"}, "/navigatr"), "; did you mean '/uxv/navigator'?");
  EXPECT_EQ(suggested_names({"/uxv/odom"}, "/gcs/odom"), "");
}

TEST(SuggestedNames, AreNotTheGivenNameItself) {
  EXPECT_EQ(suggested_names({"/odom"}, "/odom"), "");
  EXPECT_EQ(suggested_names({}, "/odom"), "");
}

}  // namespace
}  // namespace tocsin::topic_tool
