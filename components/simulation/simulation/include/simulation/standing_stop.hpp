// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "foundation/time.hpp"
#include "simulation/observer.hpp"

namespace tocsin::simulation {

/// Since when an emergency stop stands on a vehicle's host, by what its readers were given: what
/// its router reports, the silence of a router that was received before, and writers of the host.
///
/// Says less than EmergencyStopInput, never more: the stop of a writer that has gone is not
/// counted. Pure; `now` must not decrease.
class StandingStop {
 public:
  static constexpr Duration silent_after = std::chrono::seconds(1);

  void on_link(bool stands, Time now);
  void on_writer(const TopicEnd& writer, bool pressed, Time now);
  /// Those of a process, host/name, which has ended.
  void on_process_ended(const std::string& process);
  /// A process of the host has begun: it may be the driver, which cannot have heard what was
  /// before.
  void on_process_started(Time now) { listens_since_ = now; }
  [[nodiscard]] std::optional<Time> since(Time now) const;

 private:
  std::optional<Time> link_;      ///< since when the router reports a stop
  std::optional<Time> received_;  ///< the router's last report
  std::map<const TopicEnd*, Time> writers_;
  Time listens_since_ = Time::min();
};

}  // namespace tocsin::simulation
