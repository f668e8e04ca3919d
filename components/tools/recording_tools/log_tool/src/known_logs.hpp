// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin::log_tool {

/// What routers have told of their logs. Pure.
class KnownLogs {
 public:
  using State = tocsin_msgs::msg::LinkState;

  /// The state of a router, heard at `now`.
  void on_state(const State& state, Time now);
  /// Whether any router that logs something has told it.
  [[nodiscard]] bool any() const { return !logs_.empty(); }
  [[nodiscard]] bool has(const std::string& topic) const;
  /// For people: why no log is known; there is no router, or those that there are log nothing.
  [[nodiscard]] std::string why_none() const;
  /// Topics that are logged somewhere, sorted.
  [[nodiscard]] std::vector<std::string> topics() const;
  /// [ns] since the Unix epoch, the time at `now` by the clock of the host that logs the topic, as
  /// its last word told it; empty when nobody does.
  [[nodiscard]] std::optional<std::int64_t> clock_ns(const std::string& topic, Time now) const;
  /// For people: a line for each topic of each log, the age of its oldest and newest sample.
  [[nodiscard]] std::string table(Time now) const;

 private:
  struct Log {
    State state;
    Time heard{};
  };
  [[nodiscard]] static std::int64_t clock_ns(const Log& log, Time now);
  std::map<std::string, Log> logs_;  ///< by role
  bool has_heard_ = false;           ///< of any router
};

/// What a person said of a part of a log.
struct SaidRange {
  std::string from;
  std::string to = "0";
};
/// The part of a topic's log, up to now at most. Throws ConfigError for what is no time, and when
/// it is empty.
[[nodiscard]] tocsin_msgs::msg::LogRequest request_for(const std::string& topic,
                                                       const SaidRange& said,
                                                       std::int64_t clock_ns);

}  // namespace tocsin::log_tool
