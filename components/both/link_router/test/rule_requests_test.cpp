// SPDX-License-Identifier: Apache-2.0
#include "backfill/rule_requests.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

TEST(RuleRequests, AreReadAsTheyWereWritten) {
  const auto read = rule_requests_in(
      to_text({{{7, "odom", 1000, 2000}, "uxv.fetch[0]"}, {{8, "camera/image", -5, 3}, "stop"}}));
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].range.id, 7U);
  EXPECT_EQ(read[0].range.topic, "odom");
  EXPECT_EQ(read[0].range.from_ns, 1000);
  EXPECT_EQ(read[0].range.to_ns, 2000);
  EXPECT_EQ(read[0].rule, "uxv.fetch[0]");
  EXPECT_EQ(read[1].range.from_ns, -5);
  EXPECT_EQ(read[1].range.topic, "camera/image");
}

TEST(RuleRequests, LinesThatAreNoneAreLeftOut) {
  const char* const text =
      "\n7 1000\nseven 1 2 stop odom\n7 2000 1000 stop odom\n7 1 99999999999999999999 stop odom\n"
      "7 1 9000000000000000000 stop odom\n7 1 2 stop ../etc\n8 1 2 stop odom\n7 1 2 stop";
  const auto read = rule_requests_in(text);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].range.id, 8U);
}

}  // namespace
}  // namespace tocsin
