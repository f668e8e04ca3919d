// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "foundation/time.hpp"
#include "operator_console/verdict.hpp"

namespace tocsin {

/// Presses or releases the emergency stop and waits until the vehicle says that it obeys.
/// Pure; `now` must not decrease.
class EmergencyStopOrder {
 public:
  enum class Wish { on, off, status };
  EmergencyStopOrder(Wish wish, Time deadline) : wish_(wish), deadline_(deadline) {}

  /// What the ground station keeps sending.
  void on_kept(bool pressed) { kept_ = pressed; }
  /// What the vehicle says of itself.
  void on_vehicle(bool stands) { vehicle_ = stands; }
  /// What must be sent, now and again until there is a verdict.
  [[nodiscard]] std::optional<bool> request() const;
  [[nodiscard]] std::optional<Verdict> verdict(Time now) const;

 private:
  [[nodiscard]] bool obeyed() const;
  [[nodiscard]] Verdict failure() const;
  [[nodiscard]] Verdict status() const;
  Wish wish_;
  Time deadline_;
  std::optional<bool> kept_;
  std::optional<bool> vehicle_;
};

}  // namespace tocsin
