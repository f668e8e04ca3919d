// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop/stop_keeper.hpp"

namespace tocsin {

void StopKeeper::on_request(bool pressed, Time now) {
  if (wanted_ != pressed) next_ = now;
  wanted_ = pressed;
  release_until_ = now + release_said_for;
  release_said_ = false;
  confirmed_ = false;
}

void StopKeeper::on_vehicle(bool stands, bool by_station) {
  if (!wanted_ && by_station && only_station_) wanted_ = true;
  if (!stands && release_said_) confirmed_ = true;
}

bool StopKeeper::says_release(Time now) const {
  return wanted_ == false && now < release_until_ && !confirmed_;
}

std::optional<bool> StopKeeper::word(Time now) const {
  if (now < next_) return std::nullopt;
  if (wanted_ == true) return true;
  return says_release(now) ? std::optional(false) : std::nullopt;
}

void StopKeeper::said(Time now) {
  next_ = now + repeat_;
  release_said_ = wanted_ == false;
}

Time StopKeeper::due(Time now) const {
  return wanted_ == true || says_release(now) ? next_ : never;
}

}  // namespace tocsin
