// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "devices/terminal_device.hpp"
#include "event_wait.hpp"

namespace tocsin::kobuki {

/// Real time, the keys of the terminal, Ctrl-C and SIGTERM. One in a process.
class TerminalWait final : public EventWait {
 public:
  TerminalWait();
  [[nodiscard]] Time now() const override { return std::chrono::steady_clock::now(); }
  std::optional<char> wait(std::optional<int> descriptor, Time until) override;
  [[nodiscard]] bool interrupted() const override;
  /// Whether anybody can press a key.
  [[nodiscard]] bool has_keys() const { return keys_ != nullptr; }

 private:
  std::unique_ptr<TerminalDevice> keys_;  ///< null without a terminal
};

}  // namespace tocsin::kobuki
