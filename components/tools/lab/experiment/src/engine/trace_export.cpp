// SPDX-License-Identifier: Apache-2.0
#include "engine/trace_export.hpp"

#include <cmath>
#include <cstdio>

#include "foundation/error.hpp"

namespace tocsin::experiment {

std::string trace_text(const report::Recording& recording) {
  std::string text = "time_s,rssi_dbm,ping_delay_ms\n";
  int rows = 0;
  double begin_s = 0;
  for (const report::Quality& quality : recording.qualities) {
    if (!std::isfinite(quality.signal_dbm)) continue;
    if (rows++ == 0) begin_s = quality.time_s;
    char row[80];
    std::snprintf(row, sizeof row, "%.3f,%.1f,", quality.time_s - begin_s, quality.signal_dbm);
    text += row;
    if (std::isfinite(quality.rtt_mean_ms)) {
      std::snprintf(row, sizeof row, "%.2f", quality.rtt_mean_ms);
      text += row;
    }
    text += "\n";
  }
  if (rows < 2) throw ConfigError(recording.folder + ": holds no signal of a wireless link");
  return text;
}

}  // namespace tocsin::experiment
