// SPDX-License-Identifier: Apache-2.0
#include "standard_terminal.hpp"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>

namespace tocsin {
namespace {

class StandardTerminal final : public TerminalDevice {
 public:
  StandardTerminal() {
    is_terminal_ = ::tcgetattr(STDIN_FILENO, &before_) == 0;
    if (!is_terminal_) return;
    termios keys = before_;
    keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);  // ISIG stays: Ctrl-C ends
    keys.c_cc[VMIN] = 1;
    keys.c_cc[VTIME] = 0;
    ::tcsetattr(STDIN_FILENO, TCSANOW, &keys);
  }
  ~StandardTerminal() override {
    if (!is_terminal_) return;
    ::tcsetattr(STDIN_FILENO, TCSANOW, &before_);
    std::printf("\n");
    std::fflush(stdout);
  }
  StandardTerminal(const StandardTerminal&) = delete;
  StandardTerminal& operator=(const StandardTerminal&) = delete;

  [[nodiscard]] std::optional<int> descriptor() const override { return STDIN_FILENO; }

  [[nodiscard]] std::optional<std::string> read() override {
    pollfd waiting{STDIN_FILENO, POLLIN, 0};
    if (::poll(&waiting, 1, 0) == 0) return std::string();
    std::array<char, 256> bytes{};
    const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return std::string();
    if (count <= 0) return std::nullopt;
    return std::string(bytes.data(), static_cast<std::size_t>(count));
  }

  void print(const std::string& text) override {
    std::printf("%s", text.c_str());
    std::fflush(stdout);
  }
  void show(const std::string& line) override {
    if (!is_terminal_) return;
    std::printf("\r\x1b[K%s", line.c_str());
    std::fflush(stdout);
  }

 private:
  termios before_{};
  bool is_terminal_ = false;
};

}  // namespace

std::unique_ptr<TerminalDevice> open_standard_terminal() {
  return std::make_unique<StandardTerminal>();
}

}  // namespace tocsin
