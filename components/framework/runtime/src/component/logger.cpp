// SPDX-License-Identifier: Apache-2.0
#include "runtime/logger.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "component/log_lines.hpp"
#include "foundation/error.hpp"
#include "foundation/time.hpp"
#include "runtime/middleware/log_clock.hpp"

namespace tocsin {
namespace {

/// Lets a line through once a second and tells how many equal ones it kept back.
class RepetitionLimit {
 public:
  /// The number of suppressed repetitions when `line` may be printed at `now`; empty when it may
  /// not.
  std::optional<int> admit(const std::string& line, Duration now) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (lines_.size() > 256) lines_.clear();
    Entry& entry = lines_[line];
    if (entry.printed && now - entry.at < std::chrono::seconds(1)) {
      ++entry.suppressed;
      return std::nullopt;
    }
    const int suppressed = entry.suppressed;
    entry = {now, 0, true};
    return suppressed;
  }

 private:
  struct Entry {
    Duration at{0};
    int suppressed = 0;
    bool printed = false;
  };
  std::mutex mutex_;
  std::map<std::string, Entry> lines_;
};

std::shared_ptr<spdlog::logger> make_sink(const char* name, spdlog::pattern_time_type time) {
  auto made = spdlog::stderr_color_mt(name);
  made->set_pattern("%H:%M:%S.%e %^%l%$ %v", time);
  made->set_level(spdlog::level::debug);  // what is written at all is decided before
  return made;
}

spdlog::logger& real_sink() {
  static const auto sink = make_sink("tocsin", spdlog::pattern_time_type::local);
  return *sink;
}

spdlog::logger& virtual_sink() {
  static const auto sink = make_sink("tocsin_simulated", spdlog::pattern_time_type::utc);
  return *sink;
}

spdlog::level::level_enum severity_of(LogLevel level) {
  if (level <= LogLevel::debug) return spdlog::level::debug;
  if (level == LogLevel::info) return spdlog::level::info;
  return level == LogLevel::warn ? spdlog::level::warn : spdlog::level::err;
}

thread_local LogClock* clock_in_use = nullptr;

}  // namespace

struct LogClock::State {
  Now now;
  RepetitionLimit limit;
};

LogClock::LogClock(Now now) : state_(std::make_unique<State>()) { state_->now = std::move(now); }

LogClock::~LogClock() = default;

LogClock::Use::Use(LogClock& clock) : before_(std::exchange(clock_in_use, &clock)) {}

LogClock::Use::~Use() { clock_in_use = before_; }

void Logger::write(LogLevel level, const LogPlace& place, const std::string& line) {
  static RepetitionLimit real_limit;
  if (!log_levels::admit(node_, level)) return;
  const LogClock* clock = clock_in_use;
  const auto now = clock == nullptr ? std::chrono::system_clock::now() : clock->state_->now();
  const std::string named = "[" + name_ + "] " + error_line(line);
  const auto suppressed =
      clock == nullptr
          ? real_limit.admit(named, std::chrono::steady_clock::now().time_since_epoch())
          : clock->state_->limit.admit(named, now.time_since_epoch());
  if (!suppressed) return;
  const std::string more = *suppressed == 0 ? "" : fmt::format(" ({} more since)", *suppressed);
  (clock == nullptr ? real_sink() : virtual_sink())
      .log(now, spdlog::source_loc{}, severity_of(level), named + more);
  if (clock == nullptr) LogLines::push({level, node_, error_line(line) + more, now, place});
}

}  // namespace tocsin
