// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "foundation/freshness.hpp"
#include "ros_idl/diagnostic_msgs.hpp"
#include "terminal/screen.hpp"

namespace tocsin::top {

/// One status as it is shown. Texts are as they were reported; "-" where nothing was.
struct Row {
  std::string name;
  std::string host;
  std::string level;  ///< OK, WARN, ERROR or STALE
  std::string message;
  std::string rate_hz;
  std::string tick_p99_s;
  std::string tick_max_s;
  std::string overruns;
  std::string resident_mib;
  std::string depth;       ///< of the fullest input
  std::string dropped;     ///< of all inputs, since start
  std::string oldest_age;  ///< [s] of the input that was silent longest; "never"
  Duration age{0};         ///< of the report
};

/// A process that reported once, and is silent for so long that nothing is known of it.
struct Gone {
  std::string name;
  Duration age;
};

/// The last status of everything that reports on a diagnostics topic. Pure.
class HealthTable {
 public:
  /// `source` identifies the writer. What it reported before and reports no longer has ended.
  void add(const diagnostic_msgs::msg::DiagnosticArray& array, std::uint64_t source, Time now);
  /// Gravest first, then by name; what is not fresh (FreshnessLimits) is STALE, until it is
  /// unknown.
  [[nodiscard]] std::vector<Row> rows(Time now) const;
  /// Of whose processes all is unknown, for ten minutes; by name.
  [[nodiscard]] std::vector<Gone> gone(Time now) const;

 private:
  struct Entry {
    diagnostic_msgs::msg::DiagnosticStatus status;
    std::uint64_t source;
    Time at;
  };
  std::map<std::string, Entry> entries_;
};

/// A table for people, of lines of at most `width` columns: its head, what is gone, a line for each
/// row, and one more for a grave message that does not fit beside the figures.
[[nodiscard]] std::vector<terminal::Line> page(const std::vector<Row>& rows,
                                               const std::vector<Gone>& gone, std::size_t width);
/// A JSON list of objects, one line.
[[nodiscard]] std::string to_json(const std::vector<Row>& rows);

}  // namespace tocsin::top
