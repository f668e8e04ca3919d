// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <termios.h>

#include <optional>

namespace tocsin::kobuki {

/// Single keys from the terminal, without Enter; nothing when standard input is none.
class Keys {
 public:
  Keys();
  /// Gives the terminal its settings back.
  ~Keys();
  Keys(const Keys&) = delete;
  Keys& operator=(const Keys&) = delete;
  /// To poll; -1 when there is no terminal.
  [[nodiscard]] int descriptor() const;
  [[nodiscard]] std::optional<char> read();

 private:
  bool terminal_ = false;
  termios before_{};
};

}  // namespace tocsin::kobuki
