// SPDX-License-Identifier: Apache-2.0
#include "motion/safety_controller.hpp"

namespace tocsin::motion {
namespace {

bool any(const Hazards& hazards) {
  return hazards.bumper != 0 || hazards.cliff != 0 || hazards.wheel_drop != 0;
}

}  // namespace

void SafetyController::on_sensors(const Hazards& hazards, Time now) {
  now_ = hazards;
  last_sensors_ = now;
  if (!any(hazards)) return;
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

std::optional<BodyVelocity> SafetyController::override_velocity(Time now) const {
  const Hazards hazards = present(now);
  if (hazards.wheel_drop != 0) return BodyVelocity{};
  const unsigned front = hazards.bumper | hazards.cliff;
  if (front == 0 || params_.stop_only) return std::nullopt;
  if (now - last_sensors_ > seconds(params_.silence_s)) return BodyVelocity{};
  if ((front & kobuki::centre_bit) != 0) return BodyVelocity{-params_.back_off_mps, 0};
  if ((front & kobuki::left_bit) != 0) {
    return BodyVelocity{-params_.back_off_mps, -params_.turn_rad_s};
  }
  return BodyVelocity{-params_.back_off_mps, params_.turn_rad_s};
}

BodyVelocity SafetyController::filter(const BodyVelocity& wanted, Time now) const {
  const Hazards hazards = present(now);
  if (hazards.wheel_drop != 0) return {};
  const bool into = (hazards.bumper | hazards.cliff) != 0 && wanted.linear_mps > 0;
  return into ? BodyVelocity{0, wanted.angular_rad_s} : wanted;
}

}  // namespace tocsin::motion
