// SPDX-License-Identifier: Apache-2.0
#include "teleop_keyboard/key_reader.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tocsin {
namespace {

/// A letter for each key that is read: itself, ^ v > < of an arrow, ? of another key.
std::string keys_of(const std::string& bytes) {
  KeyReader sut;
  std::string keys;
  for (const char byte : bytes) {
    const auto key = sut.on_byte(byte);
    if (!key) continue;
    switch (key->kind) {
      case Key::Kind::character:
        keys += key->character;
        break;
      case Key::Kind::up:
        keys += '^';
        break;
      case Key::Kind::down:
        keys += 'v';
        break;
      case Key::Kind::right:
        keys += '>';
        break;
      case Key::Kind::left:
        keys += '<';
        break;
      default:
        keys += '?';
    }
  }
  return keys;
}

TEST(KeyReader, ReadsLettersArrowsOfBothModesAndOtherKeysAsOneEach) {
  const std::vector<std::pair<const char*, const char*>> cases{
      {"w ", "w "},
      {"\x1b[A\x1b[B\x1bOC\x1bOD", "^v><"},
      {"\x1b[1;5Aw", "^w"},  // with a modifier
      {"\x1b[15~w", "?w"},   // F5
      {"\x1b\x1bw", "w"}};   // behind the escape key
  for (const auto& [bytes, keys] : cases) EXPECT_EQ(keys_of(bytes), keys);
}

}  // namespace
}  // namespace tocsin
