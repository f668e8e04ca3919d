// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "decision/policy_params.hpp"
#include "decision/run_length.hpp"
#include "quality_trace.hpp"
#include "recording_calibration.hpp"

namespace tocsin::tools {

/// What is wanted of a detector.
struct DesignRequest {
  decision::PolicyParams params;          ///< its laws and clip
  double false_alarm_s = 3600;            ///< wanted mean time between false alarms
  double period_s = 6;                    ///< between samples
  std::optional<QualityTrace> recording;  ///< of a good network, to calibrate on
  double block_s = 0;                     ///< of resampled blocks; 0: as long as correlation lasts
  unsigned seed = 1;
  int replicates = 100;  ///< recordings that are simulated for the interval
  int paths = 3200;      ///< simulated for the threshold
};

/// One line of the trade-off: a false-alarm time and what it costs in delay.
struct TradeOff {
  double false_alarm_s;
  double alpha;
  double delay_s;        ///< mean time to the alarm when the network is bad from the start
  double reverse_alpha;  ///< the same time between false resumes in a bad network
  double reverse_delay_s;
};

/// Mean time to the alarm when quality settles at `mean` with the good law's spread.
struct ShiftDelay {
  double mean;
  double delay_s;
};

struct Design {
  DesignRequest request;
  TradeOff wanted;
  std::vector<TradeOff> table;  ///< shorter and longer times; those that cannot be had are left out
  std::vector<ShiftDelay> shifts;
  std::optional<RecordingCalibration> calibration;  ///< with a recording
};

/// Throws ConfigError when no threshold gives the wanted time.
[[nodiscard]] Design design(const DesignRequest& request);

[[nodiscard]] std::string to_text(const Design& design);
[[nodiscard]] nlohmann::json to_json(const Design& design);

}  // namespace tocsin::tools
