// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/odometry.hpp"

#include <cmath>
#include <utility>

namespace tocsin::kobuki {
namespace {

/// In a longer pause a damaged sample may look possible, and the good ones after it like a restart.
constexpr double trusted_gap_s = 0.1;
/// In a longer pause at 0.7 m/s an encoder may wrap.
constexpr double longest_known_s = 3.0;
constexpr double stamp_wrap_s = 65.536;
/// 0.7 m/s until a timeout of a second, and braking. Encoders are ambiguous from 2.79 m on.
constexpr double longest_coast_m = 1.2;

/// Signed distance between two 16-bit counters.
double tick_difference(std::uint16_t now, std::uint16_t last) {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(now - last));
}

double gyro_turn(const Inertia& from, const Inertia& to) {
  return geometry::wrap_angle((to.angle_cdeg - from.angle_cdeg) * centidegree_rad);
}

}  // namespace

Odometry::Odometry(const OdometryParams& params) : params_(params) {}

void Odometry::update(const CoreSensors& core, const std::optional<Inertia>& inertia,
                      double elapsed_s) {
  const Sample now{core, inertia};
  if (!last_) {
    last_ = now;
    return;
  }
  const bool silence = elapsed_s > longest_known_s;
  Step step = silence ? measure_over(elapsed_s, *last_, now) : measure(*last_, now);
  bool possible = silence ? bridges(step, elapsed_s) : plausible(step);
  if (!possible && !silence && undo_if_damaged(now)) {
    step = measure(*last_, now);
    possible = true;
  }
  if (!possible) ++rejected_jumps_;
  if (!possible || step.dt_s > trusted_gap_s) {
    const bool confirmed = agrees_with_suspect(now);
    const auto other = std::exchange(suspect_, Suspect{now, possible});
    if (!confirmed) return;  // the next sample may confirm this one
    if (!possible) {
      if (other->possible) return;         // this one may be damaged
      step = measure(other->sample, now);  // the base was restarted
    }
  }
  take(now, step);
}

bool Odometry::agrees_with_suspect(const Sample& now) const {
  if (!suspect_) return false;
  const Step since = measure(suspect_->sample, now);
  return plausible(since) && since.dt_s <= trusted_gap_s;
}

bool Odometry::undo_if_damaged(const Sample& now) {
  if (!before_last_) return false;
  const Step without_last = measure(before_last_->sample, now);
  // In a longer time too much is possible.
  if (!plausible(without_last) || without_last.dt_s > 2 * trusted_gap_s) return false;
  pose_ = before_last_->pose;
  gyro_heading_rad_ = before_last_->gyro_heading_rad;
  left_ = before_last_->left;
  right_ = before_last_->right;
  last_ = before_last_->sample;
  before_last_.reset();
  ++rejected_jumps_;
  return true;
}

void Odometry::take(const Sample& now, const Step& step) {
  before_last_ = State{*last_, pose_, gyro_heading_rad_, left_, right_};
  apply(step);
  apply_rates(step, now.inertia);
  last_ = now;
  suspect_.reset();
}

Odometry::Step Odometry::measure_over(double silence_s, const Sample& from,
                                      const Sample& to) const {
  Step step = measure(from, to);
  const double by_stamp_s = step.dt_s;
  step.dt_s = silence_s + std::remainder(by_stamp_s - silence_s, stamp_wrap_s);
  if (step.gyro_turn_rad) {
    *step.gyro_turn_rad -= params_.gyro_scale * params_.gyro_bias_rad_s * (step.dt_s - by_stamp_s);
  }
  return step;
}

Odometry::Step Odometry::measure(const Sample& from, const Sample& to) const {
  Step step;
  step.left_m = tick_difference(to.core.left_encoder, from.core.left_encoder) * tick_m *
                params_.left_wheel_scale;
  step.right_m = tick_difference(to.core.right_encoder, from.core.right_encoder) * tick_m *
                 params_.right_wheel_scale;
  step.turn_rad = (step.right_m - step.left_m) / params_.wheel_separation_m;
  step.dt_s = static_cast<std::uint16_t>(to.core.timestamp_ms - from.core.timestamp_ms) / 1000.0;
  if (from.inertia && to.inertia) {
    step.gyro_turn_rad = params_.gyro_scale * (gyro_turn(*from.inertia, *to.inertia) -
                                               params_.gyro_bias_rad_s * step.dt_s);
  }
  return step;
}

bool Odometry::plausible(const Step& step) const {
  constexpr double slack_m = 0.01;  // a repeated stamp or one lost frame is no jump
  // At 0.7 m/s an encoder wraps after 4 s. A stamp that went back looks like most of a minute.
  constexpr double longest_gap_s = 3.5;
  constexpr double fastest_turn_rad_s = 10;  // lifted and turned by hand
  constexpr double slack_rad = 0.1;
  if (step.dt_s > longest_gap_s) return false;
  const double limit_m = params_.max_wheel_speed_mps * step.dt_s + slack_m;
  const double limit_rad = fastest_turn_rad_s * step.dt_s + slack_rad;
  return std::abs(step.left_m) <= limit_m && std::abs(step.right_m) <= limit_m &&
         std::abs(step.gyro_turn_rad.value_or(0)) <= limit_rad;
}

bool Odometry::bridges(const Step& step, double silence_s) const {
  // The bytes may have waited: Linux keeps 4095 of a terminal that nobody reads, a second of
  // frames.
  constexpr double longest_backlog_s = 1.2;
  constexpr double latency_s = 0.3;
  constexpr double drift = 1e-3;  // of one clock against the other
  const double late_s = silence_s - step.dt_s;
  const double slack_s = latency_s + drift * silence_s;
  return late_s >= -slack_s && late_s <= longest_backlog_s + slack_s &&
         std::abs(step.left_m) <= longest_coast_m && std::abs(step.right_m) <= longest_coast_m;
}

void Odometry::apply(const Step& step) {
  double forward_m = (step.left_m + step.right_m) / 2.0;
  const bool by_gyro = params_.use_gyro_heading && step.gyro_turn_rad;
  const double turn_rad = by_gyro ? *step.gyro_turn_rad : step.turn_rad;
  double direction_rad = pose_.heading_rad;
  if (step.dt_s > trusted_gap_s && turn_rad != 0) {  // an arc whose chord counts
    direction_rad += turn_rad / 2;
    forward_m *= std::sin(turn_rad / 2) / (turn_rad / 2);
  }
  pose_.x_m += forward_m * std::cos(direction_rad);
  pose_.y_m += forward_m * std::sin(direction_rad);
  pose_.heading_rad = geometry::wrap_angle(pose_.heading_rad + turn_rad);
  gyro_heading_rad_ = geometry::wrap_angle(gyro_heading_rad_ + step.gyro_turn_rad.value_or(0));
  left_.angle_rad += step.left_m / wheel_radius_m;
  right_.angle_rad += step.right_m / wheel_radius_m;
}

void Odometry::apply_rates(const Step& step, const std::optional<Inertia>& inertia) {
  if (inertia) {
    const double reported = inertia->angle_rate_cdps * centidegree_rad;
    gyro_rate_rad_s_ = params_.gyro_scale * (reported - params_.gyro_bias_rad_s);
  }
  if (step.dt_s <= 0) return;  // the stamp did not move: the old rates are the better guess
  linear_mps_ = (step.left_m + step.right_m) / 2.0 / step.dt_s;
  angular_rad_s_ = step.turn_rad / step.dt_s;
  left_.rate_rad_s = step.left_m / wheel_radius_m / step.dt_s;
  right_.rate_rad_s = step.right_m / wheel_radius_m / step.dt_s;
  if (params_.use_gyro_heading && inertia) angular_rad_s_ = gyro_rate_rad_s_;
}

void Odometry::reset() {
  before_last_.reset();
  pose_ = geometry::Pose{};
  gyro_heading_rad_ = 0;
  left_ = right_ = WheelState{};
}

std::optional<OdometrySnapshot> Odometry::snapshot() const {
  if (!last_) return std::nullopt;
  return OdometrySnapshot{pose_, left_, right_, last_->core, last_->inertia, gyro_heading_rad_};
}

void Odometry::restore(const OdometrySnapshot& snapshot) {
  pose_ = snapshot.pose;
  left_ = snapshot.left;
  right_ = snapshot.right;
  gyro_heading_rad_ = snapshot.gyro_heading_rad;
  last_ = Sample{snapshot.core, snapshot.inertia};
  before_last_.reset();
  suspect_.reset();
}

}  // namespace tocsin::kobuki
