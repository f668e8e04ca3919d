// SPDX-License-Identifier: Apache-2.0
// What loggers of a process say, for who tells it to others, and how much of it.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "runtime/logger.hpp"

namespace tocsin {

struct LogLine {
  LogLevel level = LogLevel::info;
  std::string node;
  std::string text;
  std::chrono::system_clock::time_point time;
  LogPlace place = {};
};

/// As long as it lives, takes every line that this process logs by the computer's clock. Holds
/// `capacity`; when nobody takes them, the oldest makes room. Any thread.
class LogLines {
 public:
  static constexpr std::size_t capacity = 1000;

  /// `notice` is called, by whoever logs, when there is one to take; it must not block.
  explicit LogLines(std::function<void()> notice);
  ~LogLines();
  LogLines(const LogLines&) = delete;
  LogLines& operator=(const LogLines&) = delete;

  /// The oldest that was not taken yet.
  [[nodiscard]] std::optional<LogLine> take();
  /// Lines that had to make room since the last call.
  [[nodiscard]] std::uint64_t take_dropped();

  /// For the logger: hands a line to all that live.
  static void push(const LogLine& line);

 private:
  const std::function<void()> notice_;
  std::mutex mutex_;
  std::deque<LogLine> lines_;
  std::uint64_t dropped_ = 0;
};

}  // namespace tocsin
