// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tocsin::tools {

/// Quality over time, read from a file.
struct QualityTrace {
  std::string path;
  std::string kind;            ///< what the file was taken for
  std::vector<double> time_s;  ///< from 0
  std::vector<double> qni;     ///< [0,100]; NaN where nothing was measured
  std::vector<bool> bad;       ///< the truth, where the file has a column `state`; else empty
  /// The values that are numbers.
  [[nodiscard]] std::vector<double> measured() const;
};

/// How to read a file.
struct TraceOptions {
  std::string column;   ///< the column with the quality; empty: found by its name
  std::string role;     ///< of a recorded transmission_state.csv: whose rows; empty: all
  double period_s = 1;  ///< between rows of a file that has no time
};

/// Reads what Tocsin records (network_quality.csv, transmission_state.csv), measured Wi-Fi (columns
/// rssi_dbm, link_quality, link_quality_scale, ping_delay_ms; averaged over seconds) and plain CSV
/// with a column qni. Time is the column time_s, receive_s or t, else the rows' number.
/// Throws ConfigError with one line for everything that is wrong with the file.
[[nodiscard]] QualityTrace read_quality_trace(const std::string& path, const TraceOptions& options);

}  // namespace tocsin::tools
