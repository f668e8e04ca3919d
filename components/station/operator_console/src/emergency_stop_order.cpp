// SPDX-License-Identifier: Apache-2.0
#include "operator_console/emergency_stop_order.hpp"

#include <utility>

#include "foundation/joined.hpp"

namespace tocsin {
void EmergencyStopOrder::on_vehicle(bool stands, std::vector<std::string> stopped_by) {
  stands_ = stands;
  stopped_by_ = std::move(stopped_by);
}

std::optional<bool> EmergencyStopOrder::request() const {
  if (wish_ == Wish::status) return std::nullopt;
  return wish_ == Wish::on;
}

bool EmergencyStopOrder::is_taken() const {
  return asked_ == (wish_ == Wish::on ? Asked::on : Asked::off);
}

std::optional<bool> EmergencyStopOrder::direct(Time now) const {
  return is_taken() || now < direct_at_ ? std::nullopt : request();
}

std::optional<OrderResult> EmergencyStopOrder::result(Time now) const {
  const bool station_heard_or_late = asked_ || now >= direct_at_;
  if (wish_ == Wish::status) {
    if ((stands_ && station_heard_or_late) || now >= deadline_) return status();
    return std::nullopt;
  }
  const bool stands_as_wanted = stands_ == request();
  if (stands_as_wanted && (is_taken() || now >= direct_at_)) return obeyed();
  if (now < deadline_) return std::nullopt;
  return failure();
}

OrderResult EmergencyStopOrder::obeyed() const {
  if (wish_ == Wish::off) return {0, "emergency stop off: the vehicle may drive"};
  std::string text = "emergency stop ON: the vehicle stands";
  if (!is_taken())
    text += " (told directly; no component emergency_stop at the station says it on)";
  return {0, text};
}

OrderResult EmergencyStopOrder::failure() const {
  if (!stands_) return {1, "the vehicle is not heard; it was told again and again"};
  if (wish_ == Wish::on) return {1, "the vehicle has not confirmed the emergency stop yet"};
  return {1, "the vehicle still stands by the emergency stop of: " + joined(stopped_by_) +
                 "; each must release it itself"};
}

OrderResult EmergencyStopOrder::status() const {
  const char* asked = !asked_                     ? "kept by nobody at the station"
                      : *asked_ == Asked::nothing ? "never asked for"
                      : *asked_ == Asked::on      ? "ON"
                                                  : "off";
  std::string vehicle = "not heard";
  if (stands_) vehicle = *stands_ ? "stands by emergency stop" : "may drive";
  if (!stopped_by_.empty()) vehicle += " of: " + joined(stopped_by_);
  return {stands_ ? 0 : 1, std::string("emergency stop ") + asked + "; vehicle " + vehicle};
}

}  // namespace tocsin
