// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/core.h>

#include <string>
#include <utility>

namespace tocsin {

/// Writes lines "time level [name] text" to standard error. Thread-safe. A line that repeats
/// within a second is counted instead of printed, so that a fault cannot flood the log. Cold: the
/// compiler puts what makes a line out of the way of the code beside it.
class Logger {
 public:
  explicit Logger(std::string name) : name_(std::move(name)) {}

  template <class... Args>
  [[gnu::cold]] void info(fmt::format_string<Args...> text, Args&&... args) {
    write(Level::info, fmt::format(text, std::forward<Args>(args)...));
  }
  template <class... Args>
  [[gnu::cold]] void warn(fmt::format_string<Args...> text, Args&&... args) {
    write(Level::warn, fmt::format(text, std::forward<Args>(args)...));
  }
  template <class... Args>
  [[gnu::cold]] void error(fmt::format_string<Args...> text, Args&&... args) {
    write(Level::error, fmt::format(text, std::forward<Args>(args)...));
  }

 private:
  enum class Level { info, warn, error };
  void write(Level level, const std::string& line);
  std::string name_;
};

}  // namespace tocsin
