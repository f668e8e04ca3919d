// SPDX-License-Identifier: Apache-2.0
#include "operator_console/emergency_stop_order.hpp"

#include <algorithm>
#include <utility>

#include "foundation/joined.hpp"

namespace tocsin {
namespace {

/// Whether one of the names is of a process of `tocsin estop`, as EmergencyStopInput shows it.
bool has_order(const std::vector<std::string>& names) {
  const std::string own = std::string(EmergencyStopOrder::process) + " (";
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return name.rfind(own, 0) == 0; });
}

}  // namespace

void EmergencyStopOrder::on_vehicle(bool stands, std::vector<std::string> stopped_by) {
  if (!stands_) stood_by_order_ = has_order(stopped_by);
  stands_ = stands;
  stopped_by_ = std::move(stopped_by);
}

std::optional<bool> EmergencyStopOrder::wanted() const {
  if (wish_ == Wish::status) return std::nullopt;
  return wish_ == Wish::on;
}

std::optional<bool> EmergencyStopOrder::request() const {
  const bool is_press_at_vehicle = place_ == Place::vehicle && wish_ == Wish::on;
  return is_press_at_vehicle ? std::nullopt : wanted();
}

bool EmergencyStopOrder::is_taken() const {
  return asked_ == (wish_ == Wish::on ? Asked::on : Asked::off);
}

std::optional<bool> EmergencyStopOrder::direct(Time now) const {
  if (place_ == Place::vehicle) return wanted();
  return is_taken() || now < direct_at_ ? std::nullopt : wanted();
}

/// A stop that stood before under the same name may be another's, so that ours takes its time.
bool EmergencyStopOrder::is_pressed_here(Time now) const {
  return has_order(stopped_by_) && (!stood_by_order_ || now >= direct_at_);
}

bool EmergencyStopOrder::is_done(Time now) const {
  if (stands_ != wanted()) return false;
  if (place_ == Place::vehicle) return wish_ == Wish::off || is_pressed_here(now);
  return is_taken() || now >= direct_at_;
}

std::optional<OrderResult> EmergencyStopOrder::result(Time now) const {
  const bool station_heard_or_late = asked_ || now >= direct_at_ || place_ == Place::vehicle;
  if (wish_ == Wish::status) {
    if ((stands_ && station_heard_or_late) || now >= deadline_) return status();
    return std::nullopt;
  }
  if (is_done(now)) return obeyed();
  if (now < deadline_) return std::nullopt;
  return failure();
}

OrderResult EmergencyStopOrder::obeyed() const {
  if (wish_ == Wish::off) return {0, "emergency stop off: the vehicle may drive"};
  const std::string text = "emergency stop ON: the vehicle stands";
  if (place_ == Place::vehicle) {
    return {0, text + " (pressed on its own host; release it there)"};
  }
  if (is_taken()) return {0, text};
  return {0, text + " (told directly; no component emergency_stop at the station says it on)"};
}

OrderResult EmergencyStopOrder::failure() const {
  if (!stands_) return {1, "the vehicle is not heard; it was told again and again"};
  if (wish_ == Wish::on) return {1, "the vehicle has not confirmed the emergency stop yet"};
  const char* const how = place_ == Place::vehicle
                              ? "; who pressed it and is still received must release it"
                              : "; each must release it itself";
  return {1, "the vehicle still stands by the emergency stop of: " + joined(stopped_by_) + how};
}

OrderResult EmergencyStopOrder::status() const {
  const char* asked = !asked_                   ? "kept by nobody at the station"
                      : *asked_ == Asked::never ? "never asked for"
                      : *asked_ == Asked::on    ? "ON"
                                                : "off";
  std::string vehicle = "not heard";
  if (stands_) vehicle = *stands_ ? "stands by emergency stop" : "may drive";
  if (!stopped_by_.empty()) vehicle += " of: " + joined(stopped_by_);
  if (place_ == Place::vehicle) return {stands_ ? 0 : 1, "vehicle " + vehicle};
  return {stands_ ? 0 : 1, std::string("emergency stop ") + asked + "; vehicle " + vehicle};
}

}  // namespace tocsin
