// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emergency_stop_input/stop_state_words.hpp"
#include "foundation/time.hpp"
#include "operator_console/order_result.hpp"

namespace tocsin {

/// Presses or releases the emergency stop and waits until the vehicle says that it obeys.
///
/// The ground station's component emergency_stop is asked to; when it has not taken the order after
/// a second (it does not run, or hangs), the vehicle is told directly.
///
/// On the vehicle's host there is no station to ask. A stop is said to the vehicle at once; a
/// release also asks its router to end what stations that are not received any more have left.
/// Pure; `now` must not decrease.
class EmergencyStopOrder {
 public:
  /// The name of the process that gives it, under which it presses on a vehicle's own host.
  static constexpr const char* process = "estop";
  enum class Wish { on, off, status };
  /// What the ground station's component said last that a person asked it for.
  using Asked = StopAsked;
  /// On whose host the order is given.
  enum class Place { station, vehicle };
  static constexpr Duration direct_after = std::chrono::seconds(1);

  EmergencyStopOrder(Wish wish, Time now, Duration wait, Place place = Place::station)
      : wish_(wish), place_(place), direct_at_(now + direct_after), deadline_(now + wait) {}

  void on_station(Asked asked) { asked_ = asked; }
  /// What the vehicle says of itself, heard from it or told by the station: whether it stands by
  /// the emergency stop, and by whose. On its own host only what it says itself.
  void on_vehicle(bool stands, std::vector<std::string> stopped_by);
  /// What must be asked of the station, or of the vehicle's router, now and again until there is a
  /// result.
  [[nodiscard]] std::optional<bool> request() const;
  /// What must be said to the vehicle itself, now and again.
  [[nodiscard]] std::optional<bool> direct(Time now) const;
  [[nodiscard]] std::optional<OrderResult> result(Time now) const;

 private:
  [[nodiscard]] std::optional<bool> wanted() const;
  [[nodiscard]] bool is_taken() const;
  [[nodiscard]] bool is_pressed_here(Time now) const;
  [[nodiscard]] bool is_done(Time now) const;
  [[nodiscard]] OrderResult obeyed() const;
  [[nodiscard]] OrderResult failure() const;
  [[nodiscard]] OrderResult status() const;
  Wish wish_;
  Place place_;
  Time direct_at_;
  Time deadline_;
  std::optional<Asked> asked_;  ///< empty: the station's component was not heard
  std::optional<bool> stands_;  ///< empty: the vehicle was not heard
  std::vector<std::string> stopped_by_;
  bool stood_by_order_ = false;  ///< when the vehicle was first heard
};

}  // namespace tocsin
