// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/refused_names.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tocsin {
namespace {

using News = RefusedNames::News;

TEST(RefusedNames, AreCountedByNameAndPeerAndToldOnceByName) {
  RefusedNames sut;
  EXPECT_EQ(sut.add("topic cmd_vel", "gcs"), News::first);
  EXPECT_EQ(sut.add("topic cmd_vel", "gcs"), News::none);
  EXPECT_EQ(sut.add("topic cmd_vel", "other"), News::none);
  EXPECT_EQ(sut.add("topic odom", ""), News::first);
  EXPECT_EQ(sut.total(), 4U);
  EXPECT_EQ(sut.lines().at("topic cmd_vel from gcs"), 2U);
  EXPECT_EQ(sut.lines().at("topic cmd_vel from other"), 1U);
  EXPECT_EQ(sut.lines().at("topic odom from an unnamed peer"), 1U);
}

TEST(RefusedNames, BeyondTheirRoomAreCountedTogetherAndToldOnce) {
  RefusedNames sut;
  for (std::size_t i = 0; i < RefusedNames::most_lines; ++i) {
    EXPECT_EQ(sut.add("topic t" + std::to_string(i), "gcs"), News::first);
  }
  EXPECT_EQ(sut.add("topic more", "gcs"), News::full);
  EXPECT_EQ(sut.add("topic another", "gcs"), News::none);
  for (int i = 0; i < 100000; ++i) (void)sut.add("topic x" + std::to_string(i), "gcs");
  EXPECT_EQ(sut.lines().size(), RefusedNames::most_lines + 1);
  EXPECT_EQ(sut.lines().at(RefusedNames::others), 100002U);
  EXPECT_EQ(sut.add("topic t3", "gcs"), News::none);
  EXPECT_EQ(sut.lines().at("topic t3 from gcs"), 2U);
}

TEST(RefusedNames, AreShownAsPrintableTextOfBoundedLength) {
  RefusedNames sut;
  (void)sut.add("topic \x1b[2J\n", "g\x07s");
  EXPECT_EQ(sut.lines().begin()->first, "topic \\x1b[2J\\n from g\\x07s");
  (void)sut.add(std::string(5000, 'x'), std::string(5000, 'y'));
  EXPECT_LT(sut.lines().rbegin()->first.size(), 300U);
}

TEST(RefusedNames, OfThisProcessGrow) {
  Logger log("link");
  const auto before = refused_names().total();
  refuse("topic", "cmd_vel", "gcs", log);
  refuse("topic", "cmd_vel", "gcs", log);
  EXPECT_EQ(refused_names().total() - before, 2U);
}

}  // namespace
}  // namespace tocsin
