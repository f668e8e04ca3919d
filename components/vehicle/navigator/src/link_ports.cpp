// SPDX-License-Identifier: Apache-2.0
#include "navigator/link_ports.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "geometry/pose_message.hpp"

namespace tocsin {
namespace {

/// Whether its cells are a grid with at least one cell, whose rows are not turned.
bool is_grid(const topic::LinkRisk::Message& message) {
  constexpr std::uint32_t most_cells = 4'000'000;
  const auto& info = message.info();
  const double origin_m =
      std::abs(info.origin().position().x()) + std::abs(info.origin().position().y());
  const auto cells = std::uint64_t{info.width()} * info.height();
  return cells > 0 && cells <= most_cells && cells == message.data().size() &&
         info.resolution() > 0.001F && info.resolution() < 1000 && origin_m < 1e6 &&
         std::abs(geometry::pose_in(info.origin()).heading_rad) <= 1e-3;
}

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
    : risk_(owner, WakeMode::time_triggered), choice_(owner), log_(owner.name(), owner.node()) {}

void LinkPorts::take(Navigator& navigator) {
  auto message = risk_.take_latest();
  if (!message) return;
  const auto& info = message->info();
  if (!is_grid(*message)) {
    log_.warn("link_risk is ignored: {} cells of {} m, {} x {}", message->data().size(),
              info.resolution(), info.width(), info.height());
    return;
  }
  const navigation::Grid grid{static_cast<int>(info.width()),
                              static_cast<int>(info.height()),
                              info.resolution(),
                              {info.origin().position().x(), info.origin().position().y()}};
  navigator.set_link({grid, std::move(message->data())});
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
