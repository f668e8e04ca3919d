// SPDX-License-Identifier: Apache-2.0
#include "idl_support/ros_description.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const RosField whole_fields[] = {{"z", 145, 0, 0, "p/msg/Z"}, {"a", 1, 0, 0, "p/msg/A"}};
const RosField a_fields[] = {{"z", 1, 0, 0, "p/msg/Z"}, {"x", 11, 0, 0, ""}};
const RosField z_fields[] = {{"text", 21, 0, 8, ""}};

class RosDescriptionTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    register_ros_description({"p/msg/Whole", "RIHS01_w", whole_fields, 2});
    register_ros_description({"p/msg/Z", "RIHS01_z", z_fields, 1});
    register_ros_description({"p/msg/A", "RIHS01_a", a_fields, 2});
  }
  static std::vector<std::string> names(const std::string& hash) {
    std::vector<std::string> found;
    for (const auto& one : describe_ros_hash(hash)) found.push_back(one.name);
    return found;
  }
};

TEST_F(RosDescriptionTest, ATypeIsFollowedByItsPartsOnceEachInOrder) {
  EXPECT_THAT(names("RIHS01_w"), ElementsAre("p/msg/Whole", "p/msg/A", "p/msg/Z"));
  EXPECT_THAT(names("RIHS01_a"), ElementsAre("p/msg/A", "p/msg/Z"));
  EXPECT_THAT(names("RIHS01_z"), ElementsAre("p/msg/Z"));
}

TEST_F(RosDescriptionTest, AnUnknownHashHasNone) {
  EXPECT_THAT(names("RIHS01_q"), IsEmpty());
  EXPECT_THAT(names(""), IsEmpty());
}

TEST_F(RosDescriptionTest, FieldsAreThoseThatWereRegistered) {
  const auto found = describe_ros_hash("RIHS01_z");
  ASSERT_EQ(found.at(0).size, 1U);
  EXPECT_STREQ(found[0].fields[0].name, "text");
  EXPECT_EQ(found[0].fields[0].string_capacity, 8U);
}

}  // namespace
}  // namespace tocsin
