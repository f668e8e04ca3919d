// SPDX-License-Identifier: Apache-2.0
// The key hash of RTPS 2.2, section 9.6.3.3, by which all makers tell instances apart.
#include "fast_dds/instance_key.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "ros_idl/std_msgs.hpp"
#include "runtime/middleware/fast_dds_qos.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using Hash = eprosima::fastdds::rtps::InstanceHandle_t;

/// A type whose messages are texts and whose key is the whole text.
TypeInfo text_type(std::size_t longest_key) {
  TypeInfo type = type_info<std_msgs::msg::String>();
  type.longest_key = longest_key;
  type.serialize_key = [](const void* message, std::uint8_t* buffer, std::size_t capacity) {
    const auto& text = *static_cast<const std::string*>(message);
    if (text.size() > capacity) return std::size_t{0};
    std::memcpy(buffer, text.data(), text.size());
    return text.size();
  };
  return type;
}

std::vector<int> bytes_of(const Hash& hash) {
  std::vector<int> bytes;
  for (int i = 0; i < 16; ++i) bytes.push_back(hash.value[static_cast<std::size_t>(i)]);
  return bytes;
}

TEST(KeyHash, ATypeWithoutAKeyHasNone) {
  Hash hash;
  const std::string text = "a";
  EXPECT_FALSE(key_hash(type_info<std_msgs::msg::String>(), &text, false, hash));
  EXPECT_EQ(instance_of(type_info<std_msgs::msg::String>(), &text), 0U);
}

TEST(KeyHash, AKeyThatAlwaysFitsIsItsOwnHash) {
  Hash hash;
  const std::string text = "abc";
  ASSERT_TRUE(key_hash(text_type(16), &text, false, hash));
  EXPECT_THAT(bytes_of(hash), ElementsAre('a', 'b', 'c', 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0));
}

/// MD5 of "abc", RFC 1321, appendix A.5.
TEST(KeyHash, AKeyThatMayBeLongerIsHashedHoweverShortItIs) {
  const std::vector<int> md5{0x90, 0x01, 0x50, 0x98, 0x3c, 0xd2, 0x4f, 0xb0,
                             0xd6, 0x96, 0x3f, 0x7d, 0x28, 0xe1, 0x7f, 0x72};
  Hash hash;
  const std::string text = "abc";
  ASSERT_TRUE(key_hash(text_type(17), &text, false, hash));
  EXPECT_THAT(bytes_of(hash), ElementsAreArray(md5));
  ASSERT_TRUE(key_hash(text_type(16), &text, true, hash));
  EXPECT_THAT(bytes_of(hash), ElementsAreArray(md5));
}

TEST(KeyHash, ATextMayBeLongerThanTheLengthThatIsExpected) {
  Hash one;
  Hash other;
  const std::string text(5000, 'x');
  const std::string longer = text + "y";
  ASSERT_TRUE(key_hash(text_type(260), &text, false, one));
  ASSERT_TRUE(key_hash(text_type(260), &longer, false, other));
  EXPECT_NE(instance_of(one), instance_of(other));
}

TEST(KeyHash, TheSameKeyIsTheSameInstanceAndAnotherIsAnother) {
  const TypeInfo type = text_type(16);
  const std::string red = "red";
  const std::string again = "red";
  const std::string blue = "blue";
  EXPECT_EQ(instance_of(type, &red), instance_of(type, &again));
  EXPECT_NE(instance_of(type, &red), instance_of(type, &blue));
  const std::string nothing;
  EXPECT_NE(instance_of(type, &nothing), 0U) << "0 is no instance";
}

TEST(KeyedQos, HoldsForEachOfAnyNumberOfInstances) {
  QosProfile profile;
  profile.depth = 4;
  const auto writer = writer_qos(profile, Keys::some);
  const auto reader = reader_qos(profile, Keys::some);
  for (const auto& limits : {writer.resource_limits(), reader.resource_limits()}) {
    EXPECT_EQ(limits.max_instances, 0);
    EXPECT_EQ(limits.max_samples, 0);
    EXPECT_EQ(limits.max_samples_per_instance, 5);
  }
  EXPECT_FALSE(writer.writer_data_lifecycle().autodispose_unregistered_instances);
  EXPECT_EQ(reader.endpoint().history_memory_policy,
            eprosima::fastdds::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE)
      << "the others have no room for the end of an instance";
  EXPECT_EQ(writer_qos(profile).resource_limits().max_instances, 1);
}

}  // namespace
}  // namespace tocsin
