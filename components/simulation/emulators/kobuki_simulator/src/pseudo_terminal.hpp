// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "foundation/bytes.hpp"
#include "foundation/file_descriptor.hpp"

namespace tocsin::kobuki {

/// The simulator's end of a pseudo-terminal whose other end is found through a symbolic link.
///
/// Bytes sent while nobody has the other end open are dropped, as a real port does. When the
/// computer closes it, `renew` makes a fresh terminal: exclusive use (TIOCEXCL) by a killed program
/// would otherwise stay and lock everybody out.
class PseudoTerminal {
 public:
  /// Replaces a symbolic link at `link`, also a stale one. Throws ConfigError when something else
  /// is there, EnvironmentError when the machine gives no terminal.
  explicit PseudoTerminal(std::string link);
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  [[nodiscard]] int descriptor() const { return master_.get(); }
  [[nodiscard]] bool is_open() const { return static_cast<bool>(master_); }
  /// Whether a program has the other end open.
  [[nodiscard]] bool in_use() const;
  /// Never blocks; what does not fit is lost.
  void send(ByteView bytes);
  /// At most `size` bytes that the computer sent; 0 when there are none.
  [[nodiscard]] std::size_t receive(std::uint8_t* to, std::size_t size);
  /// A fresh terminal under the same link.
  void renew();
  /// As if the cable were pulled: terminal and link disappear.
  void remove();

 private:
  std::string link_;
  FileDescriptor master_;
};

}  // namespace tocsin::kobuki
