// SPDX-License-Identifier: Apache-2.0
#include "runtime/logger.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <map>
#include <mutex>

namespace tocsin {
namespace {

/// Lets a line through once a second and tells how many equal ones it kept back.
class RepetitionLimit {
 public:
  /// The number of suppressed repetitions when `line` may be printed now, -1 when it may not.
  int admit(const std::string& line) {
    const auto now = std::chrono::steady_clock::now();
    const std::lock_guard<std::mutex> lock(mutex_);
    if (lines_.size() > 256) lines_.clear();
    Entry& entry = lines_[line];
    if (entry.printed && now - entry.at < std::chrono::seconds(1)) {
      ++entry.suppressed;
      return -1;
    }
    const int suppressed = entry.suppressed;
    entry = {now, 0, true};
    return suppressed;
  }

 private:
  struct Entry {
    std::chrono::steady_clock::time_point at;
    int suppressed = 0;
    bool printed = false;
  };
  std::mutex mutex_;
  std::map<std::string, Entry> lines_;
};

spdlog::logger& sink() {
  static const std::shared_ptr<spdlog::logger> logger = [] {
    auto made = spdlog::stderr_color_mt("tocsin");
    made->set_pattern("%H:%M:%S.%e %^%l%$ %v");
    return made;
  }();
  return *logger;
}

}  // namespace

void Logger::write(Level level, const std::string& line) {
  static RepetitionLimit limit;
  const std::string named = "[" + name_ + "] " + line;
  const int suppressed = limit.admit(named);
  if (suppressed < 0) return;
  const auto severity = level == Level::info   ? spdlog::level::info
                        : level == Level::warn ? spdlog::level::warn
                                               : spdlog::level::err;
  if (suppressed == 0) {
    sink().log(severity, named);
  } else {
    sink().log(severity, "{} ({} more since)", named, suppressed);
  }
}

}  // namespace tocsin
