// SPDX-License-Identifier: Apache-2.0
#include "safety_controller/safety_controller.hpp"

#include <cmath>

namespace tocsin {
namespace {

bool any(const Hazards& hazards) {
  return hazards.bumper != 0 || hazards.cliff != 0 || hazards.wheel_drop != 0;
}

bool same(const geometry::Twist& a, const geometry::Twist& b) {
  return a.linear_mps == b.linear_mps && a.angular_rad_s == b.angular_rad_s;
}

}  // namespace

void SafetyController::on_hazards(const Hazards& hazards, Time now) {
  const bool was = any(now_);
  if (was) last_hazard_ = now;
  now_ = hazards;
  if (!any(hazards)) return;
  if (!was) hazard_since_ = now;
  extended_ = hazards;
  last_hazard_ = now;
}

Hazards SafetyController::present(Time now) const {
  if (!enabled_) return {};
  if (any(now_)) return now_;
  const bool lasts =
      last_hazard_ != Time::min() && now - last_hazard_ < seconds(params_.time_to_extend_s);
  return lasts ? extended_ : Hazards{};
}

std::optional<geometry::Twist> SafetyController::override_velocity(Time now) const {
  const Hazards hazards = present(now);
  if (stopped_ || hazards.wheel_drop != 0) return geometry::Twist{};
  const unsigned front = hazards.bumper | hazards.cliff;
  if (front == 0 || params_.stop_only) return std::nullopt;
  if (now - hazard_since_ >= seconds(params_.back_off_s)) return std::nullopt;
  if ((front & kobuki::centre_bit) != 0) return geometry::Twist{-params_.back_off_mps, 0};
  if ((front & kobuki::left_bit) != 0) {
    return geometry::Twist{-params_.back_off_mps, -params_.turn_rad_s};
  }
  return geometry::Twist{-params_.back_off_mps, params_.turn_rad_s};
}

/// No forward motion into a bump or cliff; backwards and turning stay possible.
geometry::Twist SafetyController::filter(const geometry::Twist& wanted, Time now) const {
  if (!std::isfinite(wanted.linear_mps) || !std::isfinite(wanted.angular_rad_s)) return {};
  const Hazards hazards = present(now);
  const bool into = (hazards.bumper | hazards.cliff) != 0 && wanted.linear_mps > 0;
  return into ? geometry::Twist{0, wanted.angular_rad_s} : wanted;
}

geometry::Twist SafetyController::send(const geometry::Twist& velocity, Time now) {
  sent_ = velocity;
  next_repeat_ = now + repeat;
  return velocity;
}

geometry::Twist SafetyController::on_wanted(const geometry::Twist& wanted, Time now) {
  const auto own = override_velocity(now);
  overriding_ = own.has_value();
  return send(own ? *own : filter(wanted, now), now);
}

std::optional<geometry::Twist> SafetyController::update(Time now) {
  const auto own = override_velocity(now);
  const bool ended = overriding_ && !own;
  overriding_ = own.has_value();
  if (own) {
    const bool due = now >= next_repeat_ && !same(*own, {});
    if (same(*own, sent_) && !due) return std::nullopt;
    return send(*own, now);
  }
  const geometry::Twist held = ended ? geometry::Twist{} : filter(sent_, now);
  if (same(held, sent_)) return std::nullopt;
  return send(held, now);
}

Time SafetyController::next_deadline(Time now) const {
  return override_velocity(now) && !same(sent_, {}) ? next_repeat_ : never;
}

}  // namespace tocsin
