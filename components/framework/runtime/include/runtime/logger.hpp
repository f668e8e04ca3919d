// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/core.h>

#include <string>
#include <utility>

#include "runtime/middleware/log_lines.hpp"
#include "runtime/middleware/log_text.hpp"

namespace tocsin {

/// Writes lines "time level [name] text" to standard error, and to /rosout where a container tells
/// it, from the level on that its node has (log_levels). Thread-safe. A line that repeats within a
/// second is counted instead of written, so that a fault cannot flood the log. Cold: the compiler
/// puts what makes a line out of the way of the code beside it.
class Logger {
 public:
  explicit Logger(const std::string& name) : Logger(name, name) {}
  /// `node`: what ROS 2 calls who logs.
  Logger(std::string name, std::string node) : name_(std::move(name)), node_(std::move(node)) {}

  /// For who looks for a fault: not written unless somebody has asked for it.
  template <class... Args>
  [[gnu::cold]] void debug(LogTextFor<Args...> text, Args&&... args) {
    if (!log_levels::admit(node_, LogLevel::debug)) return;
    write(LogLevel::debug, text.place, fmt::format(text.text, std::forward<Args>(args)...));
  }

  template <class... Args>
  [[gnu::cold]] void info(LogTextFor<Args...> text, Args&&... args) {
    write(LogLevel::info, text.place, fmt::format(text.text, std::forward<Args>(args)...));
  }
  template <class... Args>
  [[gnu::cold]] void warn(LogTextFor<Args...> text, Args&&... args) {
    write(LogLevel::warn, text.place, fmt::format(text.text, std::forward<Args>(args)...));
  }
  template <class... Args>
  [[gnu::cold]] void error(LogTextFor<Args...> text, Args&&... args) {
    write(LogLevel::error, text.place, fmt::format(text.text, std::forward<Args>(args)...));
  }

 private:
  void write(LogLevel level, const LogPlace& place, const std::string& line);
  std::string name_;
  std::string node_;
};

}  // namespace tocsin
