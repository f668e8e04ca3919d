// SPDX-License-Identifier: Apache-2.0
#include "teleop_keyboard/key_reader.hpp"

namespace tocsin {
namespace {

constexpr char escape_byte = '\x1b';

Key arrow(char last) {
  switch (last) {
    case 'A':
      return {Key::Kind::up};
    case 'B':
      return {Key::Kind::down};
    case 'C':
      return {Key::Kind::right};
    case 'D':
      return {Key::Kind::left};
    default:
      return {};
  }
}

/// Digits and ';' are parameters, as in `ESC [ 1 ; 5 A`; what follows them ends the sequence.
bool is_parameter(char byte) { return (byte >= '0' && byte <= '9') || byte == ';'; }

}  // namespace

std::optional<Key> KeyReader::on_byte(char byte) {
  if (byte == escape_byte) {
    state_ = State::escape;
    return std::nullopt;
  }
  switch (state_) {
    case State::plain:
      return Key{Key::Kind::character, byte};
    case State::escape:
      if (byte == '[' || byte == 'O') {
        state_ = State::sequence;
        return std::nullopt;
      }
      state_ = State::plain;  // the Escape key was pressed before this one
      return Key{Key::Kind::character, byte};
    case State::sequence:
      break;
  }
  if (is_parameter(byte)) return std::nullopt;
  state_ = State::plain;
  return arrow(byte);
}

}  // namespace tocsin
