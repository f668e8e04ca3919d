// SPDX-License-Identifier: Apache-2.0
#include "explorer/exploration_drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace tocsin {
namespace {

using exploration::Step;

constexpr Duration again_after_rejection = std::chrono::seconds(5);
constexpr int most_rejections = 12;
constexpr double moved_m = 0.1;  // more is getting on
constexpr double moved_rad = 0.3;

std::string text_of(const geometry::Point& goal, std::size_t given_up) {
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), "exploring: to (%.2f, %.2f), %zu places given up",
                goal.x_m, goal.y_m, given_up);
  return text.data();
}

}  // namespace

ExplorationDrive::ExplorationDrive(const Params& params)
    : params_(params), explorer_(params.explorer) {
  if (params.autostart) start();
}

void ExplorationDrive::start() {
  is_stopping_ = false;
  if (is_running_) return;
  is_running_ = true;
  rejections_ = 0;
  next_ = {};
  explorer_ = exploration::Explorer(params_.explorer);
}

void ExplorationDrive::on_pose(const geometry::Pose& pose, Time now) {
  if (!is_finite(pose)) return;
  pose_ = pose;
  pose_at_ = now;
  const double turned_rad =
      std::abs(geometry::wrap_angle(pose.heading_rad - moved_pose_.heading_rad));
  if (distance(position(pose), position(moved_pose_)) < moved_m && turned_rad < moved_rad) return;
  moved_pose_ = pose;
  moved_at_ = now;
}

void ExplorationDrive::on_reached(Time now) {
  if (!std::exchange(is_driving_, false)) return;
  rejections_ = 0;
  next_ = now + seconds(params_.settle_s);
  explorer_.on_reached();
}

void ExplorationDrive::on_failed(const std::string& reason) {
  if (!std::exchange(is_driving_, false)) return;
  rejections_ = 0;
  next_ = {};
  explorer_.on_failed(reason);
}

void ExplorationDrive::on_rejected(const std::string& reason, Time now) {
  if (!is_driving_) return;
  if (++rejections_ >= most_rejections) return on_failed(reason);
  is_driving_ = false;
  next_ = now + again_after_rejection;
  status_ = "waiting: the navigator rejects a goal: " + reason;
}

/// Null: nothing.
const char* ExplorationDrive::missing(Time now) const {
  if (!map_) return "waiting: there is no map";
  if (!pose_ || now - pose_at_ > seconds(params_.pose_timeout_s)) {
    return "waiting: there is no fresh location";
  }
  return has_navigator_ ? nullptr : "waiting: there is no navigator";
}

ExplorationDrive::Order ExplorationDrive::update(Time now) {
  if (std::exchange(is_stopping_, false)) return finish("idle");
  if (!is_running_) return {};
  Order order;
  if (is_driving_ && now >= std::min(give_up_at_, moved_at_ + seconds(params_.stall_timeout_s))) {
    on_failed(now >= give_up_at_ ? "not reached in its time" : "it does not get on");
    order.cancel = true;
  }
  if (now < next_) return order;
  next_ = now + seconds(params_.choose_every_s);
  if (const char* const reason = missing(now)) {
    status_ = reason;
    return order;
  }
  const Order chosen = choose(now);
  return {chosen.drive_to, (order.cancel && !chosen.drive_to) || chosen.cancel};
}

ExplorationDrive::Order ExplorationDrive::choose(Time now) {
  const Step step = explorer_.next(*map_, position(*pose_));
  switch (step.what) {
    case Step::What::drive:
      return drive_to(step.goal, now);
    case Step::What::keep:
      return is_driving_ ? Order{} : drive_to(step.goal, now);
    case Step::What::wait:
      status_ = "waiting: " + step.reason;
      return {};
    case Step::What::done:
      return finish("done: " + step.reason);
  }
  return {};
}

ExplorationDrive::Order ExplorationDrive::drive_to(const geometry::Point& goal, Time now) {
  is_driving_ = true;
  moved_at_ = now;
  give_up_at_ = now + seconds(params_.goal_timeout_s);
  status_ = text_of(goal, explorer_.listed().size());
  return {geometry::Pose{goal.x_m, goal.y_m, bearing(position(*pose_), goal)}, false};
}

ExplorationDrive::Order ExplorationDrive::finish(std::string status) {
  is_running_ = false;
  status_ = std::move(status);
  return {std::nullopt, std::exchange(is_driving_, false)};
}

}  // namespace tocsin
