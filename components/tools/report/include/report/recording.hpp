// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "foundation/role.hpp"
#include "foundation/traffic_class.hpp"
#include "report/statistics.hpp"

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
  double signal_dbm;       ///< NaN: unknown
  double rtt_mean_ms = 0;  ///< NaN: no probe was answered
};

/// Where the vehicle said it was, map frame.
struct Place {
  double time_s;
  double x_m;
  double y_m;
};

/// What the radio itself tells, once a second: the truth behind the measurements.
struct LinkState {
  double time_s;
  double mean_snr_db;  ///< at the vehicle's place, mean over fading
  double busy_share;   ///< [0,1] of the second, other stations included
  double airtime_s;    ///< of our frames, both directions, since start
  double bytes;        ///< of IP packets, both directions, since start
  double late_ms;      ///< longest the emulator was late; 0 in simulation
};

/// What the router of one side estimates of its way over the link, once a second.
struct RouterState {
  double time_s;
  double capacity_bytes_per_s;  ///< headers included; NaN: not measured
  double backlog_s;             ///< what waits in the radio: the delay of the next packet
  bool by_second = false;       ///< of two paths it has chosen the second
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

/// What one side sends in one traffic class.
struct LinkClass {
  Role sender;
  TrafficClass traffic_class;
  /// The vehicle first, and the most urgent.
  [[nodiscard]] bool operator<(const LinkClass& other) const {
    return std::tie(sender, traffic_class) < std::tie(other.sender, other.traffic_class);
  }
};

/// "uxv low".
[[nodiscard]] std::string to_string(const LinkClass& link_class);

/// A run, as its recorders saw it.
struct Recording {
  std::string folder;
  std::map<LinkClass, std::vector<Arrival>> arrivals;  ///< on the other side, live
  /// What came there later, on `<topic>/backfilled`; `topic` is the one that was backfilled.
  std::map<LinkClass, std::vector<Arrival>> backfilled;
  std::vector<Decision> decisions;
  std::vector<Quality> qualities;
  /// Samples that its components wrote, sent or held back by the gate.
  std::map<LinkClass, std::uint64_t> written;
  std::vector<Place> path;
  std::vector<LinkState> link;
  /// Role of the sending side -> what its router told; nothing of a side without a router.
  std::map<Role, std::vector<RouterState>> routers;
  Mission mission;
  double begin_s = 0;  ///< first and last time seen
  double end_s = 0;
};

/// Topic -> class, of what one role sends.
using Classes = std::map<std::string, LinkClass>;

/// The classes of a traffic file; `share` is the installed folder, for a file that extends a
/// shipped one. Throws ConfigError.
[[nodiscard]] Classes load_classes(const std::string& traffic_file, Role role,
                                   const std::string& share);

/// Reads the folder of a run: `deployment.yaml` names the traffic classes, `uxv/` and `gcs/` hold
/// the recorders' files. Throws ConfigError when the folder is not one of a run, or holds no
/// recording.
[[nodiscard]] Recording load_recording(const std::string& folder);

}  // namespace tocsin::report
