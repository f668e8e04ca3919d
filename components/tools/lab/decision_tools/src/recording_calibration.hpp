// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "decision/design/calibration.hpp"
#include "decision/policy_params.hpp"
#include "quality_trace.hpp"

namespace tocsin::tools {

/// What a threshold is calibrated for, on a recording of a good network.
struct CalibrationWish {
  decision::PolicyParams params;  ///< its laws, clip and detector
  double false_alarm_s;           ///< wanted mean time between false alarms
  double block_s = 0;             ///< of resampled blocks; 0: as long as correlation lasts
  unsigned seed = 1;
  int replicates = 100;  ///< recordings that are simulated for the interval
  int paths = 3200;      ///< simulated for the threshold
};

/// A threshold and how far the recording bears it out.
struct RecordingCalibration {
  std::string file;
  std::string parameter;  ///< that the threshold is to be given to
  double period_s;        ///< between the recording's samples: the median step of its time
  double false_alarm_s;
  decision::Calibration found;
};

/// Blocks for some seconds. A step in time of more than one and a half periods is a gap. Throws
/// ConfigError naming the file when its time does not advance or it is too short to be fitted.
[[nodiscard]] RecordingCalibration calibrate_on(const QualityTrace& recording,
                                                const CalibrationWish& wish);

[[nodiscard]] std::string to_text(const RecordingCalibration& calibration);
[[nodiscard]] nlohmann::json to_json(const RecordingCalibration& calibration);

/// "90 s", "12 min", "1.5 h", "30 d".
[[nodiscard]] std::string duration_text(double s);

}  // namespace tocsin::tools
