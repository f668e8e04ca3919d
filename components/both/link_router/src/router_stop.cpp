// SPDX-License-Identifier: Apache-2.0
#include "router_stop.hpp"

#include <algorithm>
#include <random>
#include <string>
#include <utility>

#include "runtime/middleware/ros_stamp.hpp"
#include "station_stop.hpp"
#include "vehicle_stop.hpp"

namespace tocsin {
namespace {

std::unique_ptr<RouterStop::Side> make_side(Component& owner, Role role, const StopKeysFile& file,
                                            Time now) {
  if (role == Role::gcs) return std::make_unique<StationStop>(owner, file.load());
  return std::make_unique<VehicleStop>(owner, file.load(), now);
}

std::uint64_t random_instance() {
  std::random_device random;
  return std::uint64_t{random()} << 32U | random();
}

}  // namespace

RouterStop::RouterStop(Component& owner, const Context& context, LinkBus& link, SiteLink& sites,
                       Logger& log)
    : link_(link),
      sites_(sites),
      log_(log),
      role_(context.role),
      file_(context.state_path(std::string(".") + to_string(context.role) + ".link_stop")),
      side_(make_side(owner, role_, file_, owner.bus().now())),
      output_(owner) {
  value_.role = role_;
  value_.instance = random_instance();
}

void RouterStop::begin(Instant at) {
  const Time now = at.now;
  const StopNews news = link_.take_stop_news();
  side_->take(news, now);
  sites_.take(news, now);
  send_value(at);
  publish(at);
  if (now >= next_) next_ = now + stop_value_period;
  if (!file_.save(side_->kept())) log_.warn("the emergency stop cannot be kept for a restart");
}

void RouterStop::send_value(Instant at) {
  const Time now = at.now;
  StopValue value = value_;
  side_->fill(value, now);
  value.site = sites_.chosen();
  if (says_the_same(value, value_) && now < next_) return;
  if (value.stands != value_.stands) value.since_wall_ns = at.wall_ns;
  const auto wall_us = static_cast<std::uint64_t>(std::max<std::int64_t>(0, at.wall_ns / 1000));
  value.number = std::max(value_.number + 1, wall_us);
  value_ = std::move(value);
  link_.say_stop(value_);
}

void RouterStop::publish(Instant at) {
  const Time now = at.now;
  if (!side_->may_publish(now)) return;
  topic::LinkStop::Message message;
  side_->fill(message, now);
  const bool same = message_ && message_->stands() == message.stands() &&
                    message_->stopped_by() == message.stopped_by() &&
                    message_->releases() == message.releases();
  if (same && now < next_) return;
  message.stamp(ros_stamp(at.wall_ns));
  message_ = message;
  if (output_.write(std::move(message)) == Status::failed) log_.warn("the stop was not published");
}

}  // namespace tocsin
