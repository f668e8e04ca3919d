// SPDX-License-Identifier: Apache-2.0
#include "operator_console/emergency_stop_order.hpp"

namespace tocsin {

std::optional<bool> EmergencyStopOrder::request() const {
  if (wish_ == Wish::status) return std::nullopt;
  return wish_ == Wish::on;
}

bool EmergencyStopOrder::obeyed() const {
  const bool on = wish_ == Wish::on;
  return kept_ == on && vehicle_ == on;
}

std::optional<Verdict> EmergencyStopOrder::verdict(Time now) const {
  if (wish_ == Wish::status) {
    if ((kept_ && vehicle_) || now >= deadline_) return status();
    return std::nullopt;
  }
  if (obeyed()) {
    return Verdict{0, wish_ == Wish::on ? "emergency stop ON: the vehicle stands"
                                        : "emergency stop off: the vehicle may drive"};
  }
  if (now < deadline_) return std::nullopt;
  return failure();
}

Verdict EmergencyStopOrder::failure() const {
  if (kept_ != request()) {
    return {1, "nobody at the ground station took the order; does emergency_stop run there?"};
  }
  return {1, "the ground station keeps sending it, but the vehicle has not confirmed it yet"};
}

Verdict EmergencyStopOrder::status() const {
  const std::string asked = !kept_ ? "never asked for" : *kept_ ? "ON" : "off";
  const std::string vehicle = !vehicle_   ? "not heard"
                              : *vehicle_ ? "stands by emergency stop"
                                          : "may drive";
  return {vehicle_ ? 0 : 1, "emergency stop " + asked + "; vehicle " + vehicle};
}

}  // namespace tocsin
