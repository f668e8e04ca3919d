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

#include "runtime/middleware/log_text.hpp"

namespace tocsin {

/// The numbers of rcl_interfaces/msg/Log.
enum class LogLevel : std::uint8_t {
  unset = 0,
  debug = 10,
  info = 20,
  warn = 30,
  error = 40,
  fatal = 50
};
/// Nothing for another number.
[[nodiscard]] std::optional<LogLevel> to_log_level(std::uint32_t number);

/// The least level that a node of this process logs; another process's are its own. Without a
/// level of its own a node has that of all, which is `info` at the start. Any thread.
namespace log_levels {
/// Of a node, or of all where `node` is empty. `unset`: the node has none of its own again, or all
/// have `info`.
void set(const std::string& node, LogLevel level);
/// What was set; `unset` where nothing was.
[[nodiscard]] LogLevel of(const std::string& node);
[[nodiscard]] bool admit(const std::string& node, LogLevel level);
}  // namespace log_levels

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
