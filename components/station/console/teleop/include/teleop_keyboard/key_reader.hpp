// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace tocsin {

/// One key of a terminal.
struct Key {
  enum class Kind { character, up, down, left, right, other };
  Kind kind = Kind::other;
  char character = 0;  ///< of Kind::character
};

/// Turns a terminal's bytes into keys. An arrow is three bytes (`ESC [ A` or `ESC O A`), which may
/// come in pieces. Longer sequences are one key of Kind::other. Pure.
class KeyReader {
 public:
  /// The key that this byte completes, if it does.
  [[nodiscard]] std::optional<Key> on_byte(char byte);

 private:
  enum class State { plain, escape, sequence };
  State state_ = State::plain;
};

}  // namespace tocsin
