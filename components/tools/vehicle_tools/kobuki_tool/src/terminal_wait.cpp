// SPDX-License-Identifier: Apache-2.0
#include "terminal_wait.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>

#include "devices/computer.hpp"

namespace tocsin::kobuki {
namespace {

volatile std::sig_atomic_t stopped = 0;

void on_signal(int) { stopped = 1; }

}  // namespace

TerminalWait::TerminalWait() {
  if (::isatty(STDIN_FILENO) == 1) keys_ = this_computer().devices.open<TerminalDevice>();
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

std::optional<char> TerminalWait::wait(std::optional<int> descriptor, Time until) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - now());
  const int ms = static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 1000));
  // poll skips a negative descriptor.
  std::array<pollfd, 2> asked{{{descriptor.value_or(-1), POLLIN, 0},
                               {keys_ ? keys_->descriptor().value_or(-1) : -1, POLLIN, 0}}};
  if (::poll(asked.data(), asked.size(), ms) < 0) return std::nullopt;
  const auto pressed = asked[1].revents != 0 ? keys_->read() : std::nullopt;
  return pressed && !pressed->empty() ? std::optional(pressed->back()) : std::nullopt;
}

bool TerminalWait::interrupted() const { return stopped != 0; }

}  // namespace tocsin::kobuki
