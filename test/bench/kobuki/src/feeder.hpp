// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

namespace tocsin::bench {

/// A base that drives: one whole frame of 81 bytes every 20 ms into a pseudo-terminal.
class Feeder {
 public:
  Feeder();
  ~Feeder();
  Feeder(const Feeder&) = delete;
  Feeder& operator=(const Feeder&) = delete;

  /// The other end of the terminal.
  [[nodiscard]] const std::string& path() const { return path_; }
  /// When the last frame was written.
  [[nodiscard]] std::int64_t sent_ns() const { return sent_ns_; }

 private:
  void run();
  int master_;
  std::string path_;
  std::atomic<std::int64_t> sent_ns_{0};
  std::atomic<bool> over_{false};
  std::thread thread_;
};

}  // namespace tocsin::bench
