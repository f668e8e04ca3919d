// SPDX-License-Identifier: Apache-2.0
#include "auto_docking/auto_docking_component.hpp"

#include <cmath>
#include <utility>

#include "geometry/pose.hpp"
#include "geometry/pose_message.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {

namespace {

constexpr Duration report_period = std::chrono::seconds(1);

}  // namespace

void AutoDockingComponent::tick(Time now) {
  take_commands(now);
  take_goals(now);
  if (sensors_) take_sensors(now);
  const bool ended = sensors_ && (docking_.watch(now) || !docking_.running());
  if (ended) {
    sensors_.reset();
    send({});
    finish_goal(now);
  }
  report(now);
  if (sensors_) wake_at(now + silence_ + std::chrono::milliseconds(1));
}

void AutoDockingComponent::take_commands(Time now) {
  while (const auto command = command_.take()) {
    if (command->data() == "start") {
      start(now);
    } else if (command->data() == "cancel") {
      docking_.cancel();
    } else {
      log().warn("'{}' is not a command; they are: start, cancel", command->data());
    }
  }
}

/// A goal while docking runs is rejected, whoever has started it.
void AutoDockingComponent::take_goals(Time now) {
  while (const auto asked = action_.take(now)) {
    if (docking_.running()) {
      action::AutoDocking::Result why;
      why.text("docking runs already");
      action_.reject(std::move(why));
      continue;
    }
    start(now);
    action_.accept(now);
    goal_ = asked->id;
  }
  if (goal_ && action_.is_canceling(*goal_)) docking_.cancel();
}

void AutoDockingComponent::finish_goal(Time now) {
  if (!goal_) return;
  const GoalId id = *std::exchange(goal_, std::nullopt);
  action::AutoDocking::Result result;
  result.text(to_string(docking_.result()));
  if (docking_.result() == DockingResult::docked) {
    action_.succeed(id, result, now);
  } else if (action_.is_canceling(id)) {
    action_.canceled(id, result, now);
  } else {
    action_.abort(id, result, now);
  }
}

/// A start while docking runs is not a new one: the operator may repeat it over a bad link.
void AutoDockingComponent::start(Time now) {
  if (docking_.running()) return;
  docking_.start(now);
  sensors_.emplace(*this);
  seen_ = {};
  started_ = now;
  ++run_;
}

/// Decides once per frame, with each sample of core sensors; the infrared of it may come after it
/// and then counts for the next one.
void AutoDockingComponent::take_sensors(Time now) {
  if (const auto odom = sensors_->odom.take_latest()) {
    seen_.heading_rad = geometry::heading_in(odom->pose().pose().orientation());
  }
  while (const auto infrared = sensors_->infrared.take()) {
    if (infrared->data().size() < 3) continue;
    seen_.infrared = {infrared->data()[0], infrared->data()[1], infrared->data()[2]};
  }
  while (const auto core = sensors_->core.take()) {
    seen_.bumper = core->bumper();
    seen_.charger = core->charger();
    const geometry::Twist velocity = docking_.update(seen_, now);
    if (docking_.running()) send(velocity);
  }
}

void AutoDockingComponent::send(const geometry::Twist& velocity) {
  topic::CmdVelDocking::Message message;
  message.linear().x(velocity.linear_mps);
  message.angular().z(velocity.angular_rad_s);
  if (cmd_vel_.write(std::move(message)) == Status::failed) log().warn("a velocity was not sent");
}

void AutoDockingComponent::report(Time now) {
  const bool again = docking_.running() && now >= next_report_;
  if (reported_ == docking_.state() && !again) return;
  topic::DockingStatus::Message message;
  message.stamp(wall(now));
  message.run(run_);
  message.state(to_string(docking_.state()));
  message.result(to_string(docking_.result()));
  message.elapsed_s(run_ == 0 ? 0.0F : static_cast<float>(to_seconds(now - started_)));
  if (status_.write(std::move(message)) == Status::failed) return;
  if (docking_.state() == DockingState::done) log().info("{}", to_string(docking_.result()));
  if (goal_) {
    action::AutoDocking::Feedback feedback;
    feedback.state(to_string(docking_.state()));
    action_.feedback(*goal_, std::move(feedback));
  }
  reported_ = docking_.state();
  next_report_ = next_instant(report_period, now);
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::AutoDockingComponent)
