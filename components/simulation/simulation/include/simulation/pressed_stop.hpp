// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "foundation/time.hpp"

namespace tocsin::simulation {

/// What a vehicle's router owes to a stop that people at the ground station have pressed.
///
/// Once something arrives that was written `settles` after the press, it reports a stop within
/// `reported_within`; and it reports the stop until the station releases. Whatever else is on the
/// radio. Pure; `now` must not decrease.
class PressedStop {
 public:
  static constexpr Duration settles = std::chrono::seconds(1);
  static constexpr Duration reported_within = std::chrono::milliseconds(700);

  /// The station's writer has said so.
  void on_station(bool pressed, Time now);
  /// A sample of the station was delivered at the vehicle.
  void on_crossed(Time written, Time now);
  /// The vehicle's router reports. False: it has dropped a stop that nobody released.
  [[nodiscard]] bool on_link(bool stands, Time now);
  /// A router has died, is frozen, or begins: nothing is owed until something crosses again.
  void on_router() { due_.reset(); }
  /// Whether a stop is reported that must be by now.
  [[nodiscard]] bool is_reported(Time now) const;

 private:
  std::optional<Time> pressed_;
  std::optional<Time> due_;  ///< from when on the router must report a stop
  bool stands_ = false;
  bool reached_ = false;
};

}  // namespace tocsin::simulation
