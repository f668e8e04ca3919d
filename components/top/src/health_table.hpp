// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "ros_idl/diagnostic_msgs.hpp"

namespace tocsin::top {

/// One line of the view. Texts are as they were reported; "-" where nothing was.
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
};

/// The last status of everything that reports on a diagnostics topic. Pure.
class HealthTable {
 public:
  void add(const diagnostic_msgs::msg::DiagnosticArray& array, Time now);
  /// Gravest first, then by name. What was silent for more than 3 s is STALE, after 30 s gone.
  [[nodiscard]] std::vector<Row> rows(Time now) const;

 private:
  struct Entry {
    diagnostic_msgs::msg::DiagnosticStatus status;
    Time at;
  };
  std::map<std::string, Entry> entries_;
};

/// A table for people, at most `width` characters wide.
[[nodiscard]] std::string to_text(const std::vector<Row>& rows, std::size_t width);
/// A JSON list of objects, one line.
[[nodiscard]] std::string to_json(const std::vector<Row>& rows);

}  // namespace tocsin::top
