// SPDX-License-Identifier: Apache-2.0
#include "idl_support/raw_type.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

TEST(RawType, HandsOnTheBytesAsTheyAre) {
  const TypeInfo& type = raw_type("some_msgs::msg::dds_::Type_");
  const std::vector<std::uint8_t> wire{0, 1, 0, 0, 7, 8, 9};
  const auto message = type.create();
  ASSERT_TRUE(type.deserialize(wire.data(), wire.size(), message.get()));
  ASSERT_EQ(type.serialized_size(message.get()), wire.size());
  std::vector<std::uint8_t> again(wire.size());
  EXPECT_EQ(type.serialize(message.get(), again.data(), again.size()), wire.size());
  EXPECT_EQ(again, wire);
}

TEST(RawType, DoesNotWriteBeyondTheBuffer) {
  const TypeInfo& type = raw_type("some_msgs::msg::dds_::Type_");
  const auto message = std::make_shared<EncodedMessage>();
  message->bytes.resize(10);
  std::vector<std::uint8_t> small(9);
  EXPECT_EQ(type.serialize(message.get(), small.data(), small.size()), 0U);
}

TEST(RawType, LessThanAnEncapsulationHeaderIsNoMessage) {
  const TypeInfo& type = raw_type("some_msgs::msg::dds_::Type_");
  const std::vector<std::uint8_t> wire{0, 1, 0};
  EXPECT_FALSE(type.deserialize(wire.data(), wire.size(), type.create().get()));
}

TEST(RawType, HasOneObjectForEachName) {
  EXPECT_EQ(&raw_type("A"), &raw_type("A"));
  EXPECT_NE(&raw_type("A"), &raw_type("B"));
  EXPECT_STREQ(raw_type("A").name, "A");
}

}  // namespace
}  // namespace tocsin
