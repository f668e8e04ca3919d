// SPDX-License-Identifier: Apache-2.0
#include "known_logs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "command_line/said_time.hpp"
#include "foundation/error.hpp"
#include "foundation/printable.hpp"

namespace tocsin::log_tool {
namespace {

constexpr std::int64_t ns_per_s = 1'000'000'000;
constexpr double ns_of_second = 1e9;

const tocsin_msgs::msg::LoggedTopic* find(const KnownLogs::State& state, const std::string& topic) {
  const auto& logged = state.logged();
  const auto found = std::find_if(logged.begin(), logged.end(),
                                  [&topic](const auto& one) { return one.topic() == topic; });
  return found == logged.end() ? nullptr : &*found;
}

std::string age_text(std::int64_t clock_ns, std::int64_t time_ns) {
  return fmt::format("{:.1f} s", static_cast<double>(clock_ns - time_ns) / ns_of_second);
}

}  // namespace

void KnownLogs::on_state(const State& state, Time now) {
  has_heard_ = true;
  if (!state.logged().empty()) logs_[state.role()] = {state, now};
}

bool KnownLogs::has(const std::string& topic) const {
  return std::any_of(logs_.begin(), logs_.end(), [&topic](const auto& entry) {
    return find(entry.second.state, topic) != nullptr;
  });
}

std::string KnownLogs::why_none() const {
  return has_heard_
             ? "no router tells of a log (list `log` of its traffic file)"
             : "nothing runs here: no router was heard (--run-dir, --host or --domain name a "
               "host)";
}

std::vector<std::string> KnownLogs::topics() const {
  std::set<std::string> topics;
  for (const auto& entry : logs_) {
    for (const auto& logged : entry.second.state.logged()) topics.insert(logged.topic());
  }
  return {topics.begin(), topics.end()};
}

std::int64_t KnownLogs::clock_ns(const Log& log, Time now) {
  const auto& stamp = log.state.stamp();
  return stamp.sec() * ns_per_s + stamp.nanosec() + (now - log.heard).count();
}

std::optional<std::int64_t> KnownLogs::clock_ns(const std::string& topic, Time now) const {
  for (const auto& entry : logs_) {
    if (find(entry.second.state, topic) != nullptr) return clock_ns(entry.second, now);
  }
  return std::nullopt;
}

std::string KnownLogs::table(Time now) const {
  std::string text =
      fmt::format("{:<40}{:<6}{:>12}{:>16}{:>16}\n", "topic", "of", "samples", "oldest", "newest");
  for (const auto& [role, log] : logs_) {
    const std::int64_t clock = clock_ns(log, now);
    for (const auto& logged : log.state.logged()) {
      text += fmt::format("{:<40}{:<6}{:>12}{:>16}{:>16}\n", printable(logged.topic()),
                          printable(role), logged.samples(), age_text(clock, logged.first_ns()),
                          age_text(clock, logged.last_ns()));
    }
  }
  return text;
}

tocsin_msgs::msg::LogRequest request_for(const std::string& topic, const SaidRange& said,
                                         std::int64_t clock_ns) {
  tocsin_msgs::msg::LogRequest request;
  request.topic(topic);
  request.from_ns(time_of("--from", said.from, clock_ns));
  request.to_ns(std::min(time_of("--to", said.to, clock_ns), clock_ns));
  if (request.from_ns() < request.to_ns()) return request;
  throw ConfigError("--from: '" + printable(said.from) + "' is not before --to and now");
}

}  // namespace tocsin::log_tool
