// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

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

/// Where a line of the log is written in the source.
struct LogPlace {
  const char* file = "";  ///< as the compiler was given it
  const char* function = "";
  unsigned line = 0;
};

/// The text of a line, and by itself the place of who gives it.
template <class... Args>
struct LogText {
  template <class Text>
  constexpr LogText(const Text& given,  // NOLINT(google-explicit-constructor): a text is one
                    const char* file = __builtin_FILE(),
                    const char* function = __builtin_FUNCTION(), unsigned line = __builtin_LINE())
      : text(given), place{file, function, line} {}
  fmt::format_string<Args...> text;
  LogPlace place;
};

/// What keeps the arguments of a line from being found in its text.
template <class... Args>
struct LogTextOf {
  using type = LogText<Args...>;
};
template <class... Args>
using LogTextFor = typename LogTextOf<Args...>::type;

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
