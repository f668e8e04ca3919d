// SPDX-License-Identifier: Apache-2.0
#include "teleop_keyboard/key_reader.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tocsin {
namespace {

std::vector<Key> keys_of(const std::string& bytes) {
  KeyReader sut;
  std::vector<Key> keys;
  for (const char byte : bytes) {
    if (const auto key = sut.on_byte(byte)) keys.push_back(*key);
  }
  return keys;
}

TEST(KeyReader, ReadsLetters) {
  const auto keys = keys_of("w ");
  ASSERT_EQ(keys.size(), 2U);
  EXPECT_EQ(keys[0].kind, Key::Kind::character);
  EXPECT_EQ(keys[0].character, 'w');
  EXPECT_EQ(keys[1].character, ' ');
}

TEST(KeyReader, ReadsArrowsOfBothModes) {
  const auto keys = keys_of("\x1b[A\x1b[B\x1bOC\x1bOD");
  ASSERT_EQ(keys.size(), 4U);
  EXPECT_EQ(keys[0].kind, Key::Kind::up);
  EXPECT_EQ(keys[1].kind, Key::Kind::down);
  EXPECT_EQ(keys[2].kind, Key::Kind::right);
  EXPECT_EQ(keys[3].kind, Key::Kind::left);
}

TEST(KeyReader, ReadsAnArrowWithAModifier) {
  const auto keys = keys_of("\x1b[1;5Aw");
  ASSERT_EQ(keys.size(), 2U);
  EXPECT_EQ(keys[0].kind, Key::Kind::up);
  EXPECT_EQ(keys[1].character, 'w');
}

TEST(KeyReader, TakesOtherSequencesAsOneKey) {
  const auto keys = keys_of("\x1b[15~w");  // F5
  ASSERT_EQ(keys.size(), 2U);
  EXPECT_EQ(keys[0].kind, Key::Kind::other);
}

TEST(KeyReader, ReadsALetterAfterTheEscapeKey) {
  const auto keys = keys_of("\x1b\x1bw");
  ASSERT_EQ(keys.size(), 1U);
  EXPECT_EQ(keys[0].character, 'w');
}

}  // namespace
}  // namespace tocsin
