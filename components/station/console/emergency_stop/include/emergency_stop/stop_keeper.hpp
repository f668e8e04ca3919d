// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "foundation/time.hpp"

namespace tocsin {

/// What the ground station says about the emergency stop, and how often.
///
/// A stop is said again and again until a person releases it: whoever comes late or lost a packet
/// hears the next one. A release is said for 2 s after a person has asked for it, or until the
/// vehicle confirms it: one that was not heard then must be asked for again, so that nobody is
/// surprised by a vehicle that drives off minutes later.
///
/// Pure; `now` must not decrease.
class StopKeeper {
 public:
  struct Params {
    double repeat_s = 0.2;
    bool only_station = true;
    template <class Visitor>
    void visit(Visitor& v) {
      v("repeat_s", repeat_s, {0.05, 10}, "[s] between repetitions of a stop that stands");
      v("only_station", only_station,
        "a stop of a station that the vehicle reports is this one's; false behind a relay, and at "
        "one of several sites");
    }
  };
  static constexpr Duration release_said_for = std::chrono::seconds(2);

  explicit StopKeeper(const Params& params)
      : repeat_(seconds(params.repeat_s)), only_station_(params.only_station) {}
  /// A person presses or releases it.
  void on_request(bool pressed, Time now);
  /// What the vehicle says: whether it stands, and whether by the word of this station. A station
  /// that knows of no request takes its own stop up again, as after a restart, if it is the only
  /// one.
  void on_vehicle(bool stands, bool by_station);
  /// A stop that an earlier process of this station kept.
  void restore() { wanted_ = true; }

  /// What a person has asked for; empty: nothing yet.
  [[nodiscard]] std::optional<bool> wanted() const { return wanted_; }
  /// What must be said now, if anything. Call `said` when it was.
  [[nodiscard]] std::optional<bool> word(Time now) const;
  void said(Time now);
  /// When to ask for the next word.
  [[nodiscard]] Time due(Time now) const;

 private:
  [[nodiscard]] bool says_release(Time now) const;
  Duration repeat_;
  bool only_station_;
  std::optional<bool> wanted_;
  Time next_ = Time::min();
  Time release_until_ = Time::min();
  bool release_said_ = false;  ///< since the request
  bool confirmed_ = false;     ///< the vehicle has said since then that it does not stand
};

}  // namespace tocsin
