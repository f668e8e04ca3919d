// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

namespace tocsin {

/// Where keys come from and lines go to. Nothing blocks or throws.
class Terminal {
 public:
  virtual ~Terminal() = default;
  /// Readable when keys wait; -1 when there is nothing to poll.
  [[nodiscard]] virtual int descriptor() const = 0;
  /// The bytes that wait; empty when nothing can come any more.
  [[nodiscard]] virtual std::optional<std::string> read() = 0;
  /// Text that stays.
  virtual void print(const std::string& text) = 0;
  /// A line that the next one replaces.
  virtual void show(const std::string& line) = 0;
};

/// The terminal of this process: keys without echo and without waiting for Enter, as before again
/// when it is destroyed. Without a terminal, standard input as it is.
[[nodiscard]] std::unique_ptr<Terminal> open_terminal();

}  // namespace tocsin
