// SPDX-License-Identifier: Apache-2.0
#include "component/log_lines.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace tocsin {
namespace {

/// Who takes lines, in this process.
struct Takers {
  std::mutex mutex;
  std::vector<LogLines*> all;
};
Takers& takers() {
  static Takers only;
  return only;
}

struct Levels {
  std::mutex mutex;
  std::map<std::string, LogLevel> all;  ///< by node; of all nodes under the empty name
};
Levels& levels() {
  static Levels only;
  return only;
}

}  // namespace

std::optional<LogLevel> to_log_level(std::uint32_t number) {
  for (const LogLevel one : {LogLevel::unset, LogLevel::debug, LogLevel::info, LogLevel::warn,
                             LogLevel::error, LogLevel::fatal}) {
    if (number == static_cast<std::uint32_t>(one)) return one;
  }
  return std::nullopt;
}

namespace log_levels {

void set(const std::string& node, LogLevel level) {
  const std::lock_guard<std::mutex> lock(levels().mutex);
  if (level == LogLevel::unset) {
    levels().all.erase(node);
  } else {
    levels().all[node] = level;
  }
}

LogLevel of(const std::string& node) {
  const std::lock_guard<std::mutex> lock(levels().mutex);
  const auto found = levels().all.find(node);
  return found != levels().all.end() ? found->second : LogLevel::unset;
}

bool admit(const std::string& node, LogLevel level) {
  LogLevel least = of(node);
  if (least == LogLevel::unset) least = of("");
  if (least == LogLevel::unset) least = LogLevel::info;
  return level >= least;
}

}  // namespace log_levels

LogLines::LogLines(std::function<void()> notice) : notice_(std::move(notice)) {
  const std::lock_guard<std::mutex> lock(takers().mutex);
  takers().all.push_back(this);
}

LogLines::~LogLines() {
  const std::lock_guard<std::mutex> lock(takers().mutex);
  auto& all = takers().all;
  all.erase(std::remove(all.begin(), all.end(), this), all.end());
}

std::optional<LogLine> LogLines::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (lines_.empty()) return std::nullopt;
  LogLine line = std::move(lines_.front());
  lines_.pop_front();
  return line;
}

std::uint64_t LogLines::take_dropped() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(dropped_, 0);
}

void LogLines::push(const LogLine& line) {
  const std::lock_guard<std::mutex> lock(takers().mutex);
  for (LogLines* const one : takers().all) {
    {
      const std::lock_guard<std::mutex> one_lock(one->mutex_);
      if (one->lines_.size() == capacity) {
        one->lines_.pop_front();
        ++one->dropped_;
      }
      one->lines_.push_back(line);
    }
    one->notice_();
  }
}

}  // namespace tocsin
