// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "kobuki_model/base_model.hpp"
#include "laser_model/simulated_laser.hpp"
#include "pseudo_terminal.hpp"

namespace tocsin::kobuki {

/// A laser on the simulated base, behind a pseudo-terminal of its own.
class LaserTerminal {
 public:
  struct Params {
    std::string link;
    std::string profile = "rplidar_a1";
    geometry::Pose mount;  ///< on the vehicle
  };
  /// Throws ConfigError for an unknown profile, and what PseudoTerminal throws.
  LaserTerminal(const Params& params, std::shared_ptr<const laser::Scene> scene, std::uint64_t seed,
                Time now);

  /// Takes what the computer sent and sends what is due. Returns whether the terminal is a new one,
  /// whose descriptor is to be watched.
  bool step(const BaseModel& base, Time now);
  [[nodiscard]] Time next_event() const;
  [[nodiscard]] int descriptor() const { return terminal_.descriptor(); }

  /// Obeys a VERB of obey_control's `laser`; returns "ok" or "error: ...".
  [[nodiscard]] std::string obey(const std::string& verb, Time now);

 private:
  PseudoTerminal terminal_;
  laser::SimulatedLaser laser_;
  bool is_plugged_ = true;
  bool was_in_use_ = false;
};

}  // namespace tocsin::kobuki
