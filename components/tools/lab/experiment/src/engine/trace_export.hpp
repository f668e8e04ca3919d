// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "report/recording.hpp"

namespace tocsin::experiment {

/// The link of a recorded run as a trace that a channel can replay: CSV with `time_s`, `rssi_dbm`
/// and `ping_delay_ms` (empty: no answer), a row per measurement. Measurements without a signal
/// are left out. Throws ConfigError when fewer than two remain.
[[nodiscard]] std::string trace_text(const report::Recording& recording);

}  // namespace tocsin::experiment
