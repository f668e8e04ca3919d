// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "foundation/bytes.hpp"

namespace tocsin::bench {

/// A base that drives: a frame of `frame_bytes` every 20 ms into a pseudo-terminal, as a cable of
/// 115200 baud brings it, 11 bytes a millisecond.
class Feeder {
 public:
  Feeder();
  ~Feeder();
  Feeder(const Feeder&) = delete;
  Feeder& operator=(const Feeder&) = delete;

  /// The other end of the terminal.
  [[nodiscard]] const std::string& path() const { return path_; }
  static constexpr std::size_t frame_bytes = 81;
  /// When the last bytes were written.
  [[nodiscard]] std::int64_t sent_ns() const { return sent_ns_; }

 private:
  void run();
  void send(ByteView frame);
  int master_;
  std::string path_;
  std::atomic<std::int64_t> sent_ns_{0};
  std::atomic<bool> over_{false};
  std::thread thread_;
};

}  // namespace tocsin::bench
