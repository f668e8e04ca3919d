// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "foundation/state_file.hpp"
#include "foundation/stop_value.hpp"

namespace tocsin {

/// What a router keeps of the emergency stop for its successor, in place, so that a full disk does
/// not matter.
class StopKeysFile {
 public:
  struct Token {
    StopToken token{};
    bool flag = false;

    [[nodiscard]] bool operator==(const Token& other) const {
      return token == other.token && flag == other.flag;
    }
  };
  struct Content {
    bool stands = false;  ///< false where another launch has left the file
    bool others = false;  ///< the same
    std::vector<Token> tokens;

    [[nodiscard]] bool operator==(const Content& other) const {
      return stands == other.stands && others == other.others && tokens == other.tokens;
    }
  };
  static constexpr std::size_t most_tokens = 8;

  /// An empty path keeps nothing.
  explicit StopKeysFile(std::string path) : file_(std::move(path)) {}
  /// Empty when there is no file, or it is damaged. Tokens outlive a launch, what stands does not.
  [[nodiscard]] Content load() const;
  /// Writes what has changed; of more tokens the last ones. False, once, when it could not.
  [[nodiscard]] bool save(const Content& content);

 private:
  StateFile file_;
  std::optional<Content> saved_;
  bool failed_ = false;
};

}  // namespace tocsin
