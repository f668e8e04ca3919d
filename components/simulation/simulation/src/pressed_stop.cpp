// SPDX-License-Identifier: Apache-2.0
#include "simulation/pressed_stop.hpp"

namespace tocsin::simulation {

void PressedStop::on_station(bool pressed, Time now) {
  if (pressed == pressed_.has_value()) return;
  pressed_ = pressed ? std::optional(now) : std::nullopt;
  due_.reset();
  reached_ = false;
}

void PressedStop::on_crossed(Time written, Time now) {
  if (!pressed_ || due_ || written < *pressed_ + settles) return;
  due_ = now + reported_within;
}

bool PressedStop::on_link(bool stands, Time now) {
  const bool dropped = pressed_ && reached_ && !stands;
  stands_ = stands;
  if (pressed_ && stands && now >= *pressed_ + settles) reached_ = true;
  if (dropped) reached_ = false;  // tells it once
  return !dropped;
}

bool PressedStop::is_reported(Time now) const { return !due_ || now < *due_ || stands_; }

}  // namespace tocsin::simulation
