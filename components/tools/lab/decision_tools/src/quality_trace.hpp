// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "decision/outlook.hpp"
#include "decision/qni.hpp"
#include "recorded_run.hpp"

namespace tocsin::tools {

/// What a transmission_controller had decided at a row of a recording.
struct RecordedDecision {
  bool active = true;
  std::string reason;
  int pause_samples = 0;      ///< [1] samples since the pause began
  bool at_deadline = false;   ///< no sample: the pause had lasted th_max_s
  bool restarted = false;     ///< the first one of a controller that was started anew
  decision::Outlook outlook;  ///< that it had
};

/// Quality over time, read from a file.
struct QualityTrace {
  std::string path;
  std::string kind;            ///< what the file was taken for
  std::optional<Role> role;    ///< of a recorded transmission_state.csv: whose rows; else empty
  std::vector<double> time_s;  ///< from 0, not decreasing
  std::vector<double> qni;     ///< [0,100]; NaN where nothing was measured
  /// The truth: column `state` of the file; of measured Wi-Fi whether at least half of a second's
  /// probes had no answer; else empty.
  std::vector<bool> bad;
  std::vector<RecordedDecision> recorded;  ///< one per row of a transmission_state.csv; else empty
  double began_s = 0;          ///< [s since the Unix epoch] when the first of these was made
  std::size_t unrecorded = 0;  ///< decisions that did not reach that recording
  /// Of the run that the file was recorded in, when its deployment.yaml is there.
  std::optional<ControllerParameters> controller;
  /// The values that are numbers.
  [[nodiscard]] std::vector<double> measured() const;
};

/// How to read a file.
struct TraceOptions {
  std::string column;        ///< the column with the quality; empty: found by its name
  std::optional<Role> role;  ///< whose decisions; empty: those of the only role there is
  double period_s = 1;       ///< between rows of a file that has no time
  std::string topic = "network_quality";  ///< of a bag
};

/// Reads what Tocsin records (network_quality.csv, transmission_state.csv, or one of these topics
/// of a bag), measured Wi-Fi (columns rssi_dbm, link_quality, link_quality_scale, ping_delay_ms;
/// averaged over seconds) and plain CSV with a column qni. Time is when a recorded decision was
/// made, else the column time_s, receive_s or t, else the rows' number. Throws ConfigError with one
/// line for everything that is wrong with the file; also for decisions of two roles when `options`
/// name none.
[[nodiscard]] QualityTrace read_quality_trace(const std::string& path, const TraceOptions& options);

}  // namespace tocsin::tools
