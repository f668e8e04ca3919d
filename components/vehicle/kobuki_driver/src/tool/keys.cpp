// SPDX-License-Identifier: Apache-2.0
#include "keys.hpp"

#include <unistd.h>

namespace tocsin::kobuki {

Keys::Keys() {
  terminal_ = ::isatty(STDIN_FILENO) == 1 && ::tcgetattr(STDIN_FILENO, &before_) == 0;
  if (!terminal_) return;
  termios raw = before_;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  ::tcsetattr(STDIN_FILENO, TCSANOW, &raw);
}

Keys::~Keys() {
  if (terminal_) ::tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

int Keys::descriptor() const { return terminal_ ? STDIN_FILENO : -1; }

std::optional<char> Keys::read() {
  char key = 0;
  if (!terminal_ || ::read(STDIN_FILENO, &key, 1) != 1) return std::nullopt;
  return key;
}

}  // namespace tocsin::kobuki
