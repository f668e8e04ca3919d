// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "kobuki_protocol/bytes.hpp"

namespace tocsin::kobuki {

/// Where the driver's bytes come from and go to: a serial port, or a model in simulated time.
class BytePort {
 public:
  virtual ~BytePort() = default;
  /// Readable when bytes wait or the port was lost; -1 when there is nothing to poll.
  [[nodiscard]] virtual int descriptor() const = 0;
  /// At most `size` bytes, 0 when none wait; empty when the port is lost. Never blocks.
  [[nodiscard]] virtual std::optional<std::size_t> read(std::uint8_t* to, std::size_t size) = 0;
  /// False when the port is lost. Never blocks; bytes that do not fit are dropped.
  [[nodiscard]] virtual bool write(ByteView bytes) = 0;
};

/// What came of opening a port.
struct Opened {
  enum class Result { open, absent, busy };
  Result result = Result::absent;
  std::unique_ptr<BytePort> port;  ///< null unless open
  std::string reason;              ///< one line, for people
  /// Whether a living process holds a busy port, as far as we may see.
  bool held = false;
};

}  // namespace tocsin::kobuki
