// SPDX-License-Identifier: Apache-2.0
#include "teleop_receiver/driver_authority.hpp"

#include <algorithm>
#include <utility>

namespace tocsin {

/// To who asks; to nobody when nobody does.
void DriverAuthority::hand_over(Time now) {
  driver_ = std::exchange(asked_by_, std::nullopt);
  last_command_ = now;
}

void DriverAuthority::settle(Time now) {
  if (!driver_) return;
  const bool idle = now - last_command_ >= idle_;
  const bool unanswered = asked_by_ && now - asked_ >= answer_;
  if (idle || unanswered) hand_over(now);
}

bool DriverAuthority::follows(const std::string& name, Time now) {
  settle(now);
  if (!driver_) driver_ = name;
  if (*driver_ != name) {
    ++refused_;
    return false;
  }
  last_command_ = now;
  return true;
}

void DriverAuthority::ask(const std::string& name, Time now) {
  settle(now);
  if (!driver_) {
    driver_ = name;
    last_command_ = now;
  } else if (*driver_ != name && !asked_by_) {
    asked_by_ = name;
    asked_ = now;
  }
}

void DriverAuthority::give(const std::string& name, Time now) {
  settle(now);
  if (driver_ == name) hand_over(now);
}

void DriverAuthority::keep(const std::string& name) {
  if (driver_ == name) asked_by_.reset();
}

void DriverAuthority::take(const std::string& name, Time now) {
  settle(now);
  driver_ = name;
  last_command_ = now;
  if (asked_by_ == name) asked_by_.reset();
}

Time DriverAuthority::next_deadline() const {
  if (!driver_) return never;
  const Time idle = last_command_ + idle_;
  return asked_by_ ? std::min(idle, asked_ + answer_) : idle;
}

}  // namespace tocsin
