// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "foundation/time.hpp"
#include "geometry/twist.hpp"

namespace tocsin {

/// Turns what an operator holds into commands: at once when it changes, repeated while it is not
/// zero, zero three times at release, then silence, so that others get their turn.
/// Pure; `now` must not decrease.
class TeleopSender {
 public:
  struct Params {
    double rate_hz = 10;
    template <class Visitor>
    void visit(Visitor& v) {
      v("rate_hz", rate_hz, {4, 50}, "[Hz] of commands while the vehicle is driven");
    }
  };
  static constexpr int zeros = 3;

  explicit TeleopSender(const Params& params) : period_(seconds(1 / params.rate_hz)) {}
  /// What the operator wants from now on.
  void hold(const geometry::Twist& velocity);
  /// The command to send now, if one is due. Call after `hold` and at `next_deadline`.
  [[nodiscard]] std::optional<geometry::Twist> update(Time now);
  [[nodiscard]] Time next_deadline() const;
  /// Whether what is held moves the vehicle.
  [[nodiscard]] bool driving() const;

 private:
  Duration period_;
  geometry::Twist held_;
  bool changed_ = false;
  int zeros_left_ = 0;
  Time next_ = Time::min();
};

}  // namespace tocsin
