// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "statistics.hpp"

namespace tocsin::report {

/// What the controller of the vehicle decided on one sample of the network quality.
struct Decision {
  double time_s;  ///< [s] since the Unix epoch
  bool active;
  std::string policy;
  std::string reason;
  double qni;  ///< [%] NaN: none
};

/// One measurement of the link.
struct Quality {
  double time_s;
  double per_percent;
  double signal_dbm;  ///< NaN: unknown
};

/// The last that mission control reported.
struct Mission {
  std::string name;
  std::string state;
  int waypoint = 0;
  int waypoints = 0;
  int goals_sent = 0;
  double elapsed_s = 0;
};

/// A run, as its recorders saw it.
struct Recording {
  std::string folder;
  /// "uxv low", "gcs high" and so on (who sends, class) -> what arrived on the other side.
  std::map<std::string, std::vector<Arrival>> arrivals;
  std::vector<Decision> decisions;
  std::vector<Quality> qualities;
  Mission mission;
  double begin_s = 0;  ///< first and last time seen
  double end_s = 0;
};

/// Reads the folder of a run: `deployment.yaml` names the traffic classes, `uxv/` and `gcs/` hold
/// the recorders' files. Throws ConfigError when the folder is not one of a run, or holds no
/// recording.
[[nodiscard]] Recording load_recording(const std::string& folder);

}  // namespace tocsin::report
