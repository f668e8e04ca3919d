// SPDX-License-Identifier: Apache-2.0
#include "navigator/link_ports.hpp"

#include <utility>

namespace tocsin {
namespace {

tocsin_msgs::msg::PlanChoice message_of(const navigation::WayChoice& choice, double speed_mps) {
  tocsin_msgs::msg::PlanChoice message;
  message.way_m(choice.way.length_m);
  message.silence_s(choice.way.silent_m / speed_mps);
  message.shortest_m(choice.shortest.length_m);
  message.shortest_silence_s(choice.shortest.silent_m / speed_mps);
  for (const geometry::Point& corner : choice.shortest.path) {
    geometry_msgs::msg::Point point;
    point.x(corner.x_m);
    point.y(corner.y_m);
    message.shortest().push_back(point);
  }
  return message;
}

}  // namespace

LinkPorts::LinkPorts(Component& owner)
    : risk_(owner), choice_(owner), log_(owner.name(), owner.node()) {}

void LinkPorts::take(Navigator& navigator) {
  if (auto risk = risk_.take()) navigator.set_link(std::move(*risk));
}

void LinkPorts::report(const Navigator& navigator, double speed_mps,
                       const builtin_interfaces::msg::Time& stamp) {
  if (navigator.plans() == plans_) return;
  plans_ = navigator.plans();
  const auto& choice = navigator.choice();
  if (!choice) return;
  auto message = message_of(*choice, speed_mps);
  message.stamp(stamp);
  if (choice_.write(std::move(message)) == Status::failed) log_.warn("a choice was not told");
}

}  // namespace tocsin
