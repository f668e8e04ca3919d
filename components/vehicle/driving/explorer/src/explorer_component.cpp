// SPDX-License-Identifier: Apache-2.0
#include "explorer/explorer_component.hpp"

#include <utility>

#include "geometry/pose_message.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

constexpr Duration answer_time = std::chrono::seconds(2);
constexpr Duration result_slack = std::chrono::seconds(10);  // after a goal was given up

std::string reason_of(const action::NavigateToPose::Result* result, const char* otherwise) {
  return result == nullptr || result->error_msg().empty() ? otherwise : result->error_msg();
}

}  // namespace

ExplorerComponent::ExplorerComponent(Context& context, const Params& params)
    : Component(context), params_(params), drive_(params) {}

void ExplorerComponent::tick(Time now) {
  take_calls();
  if (map_.take()) drive_.on_map(*map_.map());
  take_location(now);
  drive_.on_navigator(navigate_.available());
  while (const auto news = navigate_.take(now)) on_news(*news, now);
  follow(drive_.update(now), now);
  tell();
  if (drive_.is_running()) wake_at(drive_.next());
}

void ExplorerComponent::take_calls() {
  while (const auto call = explore_.take()) {
    call->request->data() ? drive_.start() : drive_.stop();
    Explore::Response response;
    response.success(true);
    response.message(call->request->data() ? "exploring" : "stopped");
    explore_.reply(call->id, std::move(response));
  }
}

void ExplorerComponent::take_location(Time now) {
  const auto location = location_.take_latest();
  if (location) drive_.on_pose(geometry::pose_in(location->pose().pose()), now);
}

void ExplorerComponent::on_news(const ActionClient<Navigate>::News& news, Time now) {
  using What = ActionClient<Navigate>::What;
  if (!goal_ || news.id != *goal_) return;  // of a goal that was replaced
  const bool is_over =
      news.what == What::rejected || news.what == What::unanswered || news.what == What::result;
  if (!is_over) return;
  goal_.reset();
  if (news.what == What::rejected) {
    drive_.on_rejected(reason_of(news.result.get(), "no reason"), now);
  } else if (news.what == What::unanswered) {
    drive_.on_failed("the navigator does not answer");
  } else if (news.state == GoalState::succeeded) {
    drive_.on_reached(now);
  } else {
    drive_.on_failed(reason_of(news.result.get(), "the navigator gave it up"));
  }
}

void ExplorerComponent::follow(const ExplorationDrive::Order& order, Time now) {
  if (order.cancel && goal_)
    navigate_.cancel(*std::exchange(goal_, std::nullopt), now + answer_time);
  if (!order.drive_to) return;
  Navigate::Goal goal;
  goal.pose().header().frame_id("map");
  goal.pose().header().stamp(wall(now));
  goal.pose().pose(geometry::pose_message<geometry_msgs::msg::Pose>(*order.drive_to));
  const Time result_by = now + seconds(params_.goal_timeout_s) + result_slack;
  goal_ = navigate_.send(std::move(goal), now + answer_time, result_by);
}

void ExplorerComponent::tell() {
  if (drive_.status() == told_) return;
  topic::ExploreStatus::Message message;
  message.data(drive_.status());
  if (status_.write(std::move(message)) == Status::failed) return;
  told_ = drive_.status();
  log().info("{}", told_);
  const bool is_over = told_.rfind("done", 0) == 0;
  if (is_over && params_.exit_when_over) context().request_exit(0);
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::ExplorerComponent)
