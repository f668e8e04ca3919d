// SPDX-License-Identifier: Apache-2.0
#include "velocity_smoother/velocity_smoother.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin {
namespace {

constexpr double shortest_silence_s = 0.2;  // the reference has none, and brakes at any hiccup

bool is_zero(const geometry::Twist& v) { return v.linear_mps == 0 && v.angular_rad_s == 0; }

/// How much of a change fits into `limit`.
double share(double change, double limit) {
  return std::abs(change) <= limit ? 1.0 : limit / std::abs(change);
}

/// Greatest change of one coordinate in a period: braking has its own factor.
double limit(double from, double to, double accel, double decel_factor) {
  const bool braking = std::abs(to) < std::abs(from) || from * to < 0;
  return braking ? accel * decel_factor : accel;
}

}  // namespace

void VelocitySmoother::on_command(const geometry::Twist& velocity, Time now) {
  if (last_command_ != Time::min()) {
    periods_s_[heard_++ % window] = to_seconds(now - last_command_);
    if (heard_ >= window) timeout_s_ = usual_silence_s();
  }
  last_command_ = now;
  target_ = {};
  if (!std::isfinite(velocity.linear_mps) || !std::isfinite(velocity.angular_rad_s)) return;
  target_ = fitted(velocity);
}

void VelocitySmoother::set_limits(const Params& params) {
  params_ = params;
  target_ = fitted(target_);
}

geometry::Twist VelocitySmoother::fitted(const geometry::Twist& velocity) const {
  const double fit = std::min(share(velocity.linear_mps, params_.speed_lim_v_mps),
                              share(velocity.angular_rad_s, params_.speed_lim_w_rad_s));
  return {velocity.linear_mps * fit, velocity.angular_rad_s * fit};
}

double VelocitySmoother::usual_silence_s() const {
  auto sorted = periods_s_;
  std::nth_element(sorted.begin(), sorted.begin() + window / 2, sorted.end());
  return std::clamp(3 * sorted[window / 2], shortest_silence_s, longest_silence_s);
}

bool VelocitySmoother::silent(Time now) const {
  return last_command_ == Time::min() || now - last_command_ > seconds(timeout_s_);
}

geometry::Twist VelocitySmoother::wanted(Time now) const {
  return silent(now) ? geometry::Twist{} : target_;
}

bool VelocitySmoother::settled(Time now) const {
  const geometry::Twist to = wanted(now);
  return to.linear_mps == current_.linear_mps && to.angular_rad_s == current_.angular_rad_s;
}

std::optional<geometry::Twist> VelocitySmoother::update(Time now) {
  if (settled(now)) {
    if (is_zero(current_) || now < next_repeat_) return std::nullopt;
  } else {
    if (now < next_step_) return std::nullopt;
    next_step_ = now + seconds(1 / params_.frequency_hz);
  }
  next_repeat_ = now + seconds(params_.repeat_s);
  return step(now);
}

Time VelocitySmoother::next_deadline(Time now) const {
  if (!settled(now)) return next_step_;
  if (is_zero(current_)) return never;
  const Time silence = last_command_ + seconds(timeout_s_) + std::chrono::nanoseconds(1);
  return std::min(next_repeat_, silence);
}

geometry::Twist VelocitySmoother::step(Time now) {
  const geometry::Twist to = wanted(now);
  const double period_s = 1.0 / params_.frequency_hz;
  const double dv = to.linear_mps - current_.linear_mps;
  const double dw = to.angular_rad_s - current_.angular_rad_s;
  const double limit_v =
      limit(current_.linear_mps, to.linear_mps, params_.accel_lim_v_mps2, params_.decel_factor);
  const double limit_w = limit(current_.angular_rad_s, to.angular_rad_s, params_.accel_lim_w_rad_s2,
                               params_.decel_factor);
  const double part = std::min(share(dv, limit_v * period_s), share(dw, limit_w * period_s));
  current_.linear_mps += part * dv;
  current_.angular_rad_s += part * dw;
  if (part == 1.0) current_ = to;  // no rounding residue around zero
  return current_;
}

bool VelocitySmoother::at_rest(Time now) const { return silent(now) && is_zero(current_); }

}  // namespace tocsin
