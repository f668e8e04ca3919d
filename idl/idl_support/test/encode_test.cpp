// SPDX-License-Identifier: Apache-2.0
// Bytes of a message and back, for a type that is known by its TypeInfo alone.
#include "idl_support/encode.hpp"

#include <gtest/gtest.h>

#include "idl_support/decode.hpp"

namespace tocsin {
namespace {

/// A message of one byte, which is written after a mark and never is 255.
std::shared_ptr<void> create_byte() { return std::make_shared<std::uint8_t>(std::uint8_t{0}); }

/// An upper bound, as that of a type with optional members is.
std::size_t size_of_byte(const void*) { return 4; }

std::size_t write_byte(const void* message, std::uint8_t* buffer, std::size_t capacity) {
  if (capacity < 2) return 0;
  buffer[0] = 0xab;
  buffer[1] = *static_cast<const std::uint8_t*>(message);
  return 2;
}

bool read_byte(const std::uint8_t* buffer, std::size_t size, void* message) {
  if (size != 2 || buffer[0] != 0xab || buffer[1] == 255) return false;
  *static_cast<std::uint8_t*>(message) = buffer[1];
  return true;
}

const TypeInfo byte_type{"byte",     &create_byte, &size_of_byte, &write_byte,
                         &read_byte, nullptr,      nullptr,       nullptr};

TEST(Encode, GivesTheBytesThatWereWrittenAndNotTheRoomForThem) {
  const std::uint8_t message = 7;
  EXPECT_EQ(encode(byte_type, &message), (std::vector<std::uint8_t>{0xab, 7}));
}

TEST(Decode, GivesTheMessageThatEncodeWrote) {
  const std::uint8_t message = 42;
  const auto decoded = decode(byte_type, encode(byte_type, &message));
  ASSERT_TRUE(decoded);
  EXPECT_EQ(*static_cast<const std::uint8_t*>(decoded.get()), 42);
}

TEST(Decode, OfOtherBytesIsNothing) {
  EXPECT_FALSE(decode(byte_type, {}));
  EXPECT_FALSE(decode(byte_type, {0xab}));
  EXPECT_FALSE(decode(byte_type, {0xab, 255}));
}

}  // namespace
}  // namespace tocsin
