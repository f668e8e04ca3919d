// SPDX-License-Identifier: Apache-2.0
#include "collision_brake/collision_brake_component.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "geometry/pose_message.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

namespace code = nav2_msgs::msg::CollisionMonitorState_Constants;
using Action = CollisionBrake::Action;

/// As long as the smoother may drive by the last velocity.
constexpr Duration longest_silence = std::chrono::milliseconds(500);
constexpr Duration diagnostics_period = std::chrono::seconds(1);

std::uint8_t code_of(Action action) {
  switch (action) {
    case Action::none:
      return code::DO_NOTHING;
    case Action::stop:
      return code::STOP;
    case Action::approach:
      return code::APPROACH;
    case Action::limit:
      break;
  }
  return code::LIMIT;
}

bool is_same(const CollisionBrake::Verdict& a, const CollisionBrake::Verdict& b) {
  return a.action == b.action && std::strcmp(a.reason, b.reason) == 0;
}

}  // namespace

CollisionBrakeComponent::CollisionBrakeComponent(Context& context, const Params& params)
    : Component(context), brake_(params) {}

void CollisionBrakeComponent::tick(Time now) {
  while (const auto bypass = bypass_.take()) brake_.on_bypass(bypass->data(), now);
  if (std::exchange(was_bypassed_, brake_.is_bypassed(now)) != was_bypassed_) {
    log().warn("{}", was_bypassed_ ? "off, as a person asked" : "on again");
  }
  take_odometry(now);
  take_scan(now);
  if (const auto wanted = wanted_.take_latest()) {
    asked_ = {wanted->linear().x(), wanted->angular().z()};
    asked_at_ = now;
    send(now);
  }
  publish_diagnostics(now);
  wake_at(next_diagnostics_);
}

void CollisionBrakeComponent::take_odometry(Time now) {
  const auto odom = odom_.take_latest();
  if (!odom) return;
  const auto& twist = odom->twist().twist();
  velocity_ = {twist.linear().x(), twist.angular().z()};
  const geometry::Pose pose = geometry::pose_in(odom->pose().pose());
  if (!geometry::is_finite(pose)) return;
  poses_.add(stamp_ns_of(odom->header()), pose);
  brake_.on_pose(pose, velocity_, now);
}

/// What the smoother drives by is judged again: it may be too fast now.
void CollisionBrakeComponent::take_scan(Time now) {
  const auto turn = scan_.take(velocity_);
  if (!turn) return;
  const auto pose = poses_.at(turn->stamp_ns);
  if (!pose) return;
  brake_.on_scan(turn->scan, *pose, now);
  if (!asked_ || now - asked_at_ > longest_silence || wanted_.has_sample()) return;
  const double before_mps = std::abs(verdict_.velocity.linear_mps);
  if (std::abs(brake_.check(*asked_, now).velocity.linear_mps) < before_mps) send(now);
}

void CollisionBrakeComponent::send(Time now) {
  const CollisionBrake::Verdict verdict = brake_.check(*asked_, now);
  topic::CmdVelChecked::Message message;
  message.linear().x(verdict.velocity.linear_mps);
  message.angular().z(verdict.velocity.angular_rad_s);
  if (checked_.write(std::move(message)) == Status::failed) log().warn("a velocity was lost");
  report(verdict, now);
}

void CollisionBrakeComponent::report(const CollisionBrake::Verdict& verdict, Time) {
  const bool has_changed = !is_reported_ || !is_same(verdict, verdict_);
  verdict_ = verdict;
  if (has_changed) publish_state(verdict);
}

void CollisionBrakeComponent::publish_state(const CollisionBrake::Verdict& verdict) {
  topic::CollisionMonitorState::Message message;
  message.action_type(code_of(verdict.action));
  message.polygon_name(verdict.reason);
  is_reported_ = state_.write(std::move(message)) == Status::ok;
}

void CollisionBrakeComponent::publish_diagnostics(Time now) {
  if (now < next_diagnostics_) return;
  next_diagnostics_ = next_instant(diagnostics_period, now);
  if (!diagnostics_.wanted()) return;
  const CollisionBrake::Verdict ahead = brake_.check({0.1, 0}, now);
  const bool is_blind = *ahead.reason != 0 && std::strcmp(ahead.reason, "obstacle") != 0;
  diagnostic_msgs::msg::DiagnosticStatus status;
  status.level(is_blind ? 1 : 0);
  status.name(name() + ": brake");
  status.message(*ahead.reason != 0 ? ahead.reason : "free");
  topic::Diagnostics::Message message;
  message.header().stamp(wall(now));
  message.status().push_back(status);
  if (diagnostics_.write(std::move(message)) == Status::failed) log().warn("no diagnostics sent");
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::CollisionBrakeComponent)
