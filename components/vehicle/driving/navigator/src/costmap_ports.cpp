// SPDX-License-Identifier: Apache-2.0
#include "navigator/costmap_ports.hpp"

#include <chrono>
#include <utility>

#include "map_ports/map_output.hpp"

namespace tocsin {
namespace {

constexpr Duration global_period = std::chrono::seconds(1);
constexpr Duration local_period = std::chrono::milliseconds(500);
constexpr double local_side_m = 3;  // as in nav2_bringup

/// True once in each period, as far as it is asked.
bool is_due(Time& next, Duration period, Time now) {
  if (now < next) return false;
  next = now + period;
  return true;
}

}  // namespace

CostmapPorts::CostmapPorts(Component& owner)
    : global_(owner),
      local_(owner),
      clear_global_(owner),
      clear_local_(owner),
      log_(owner.name(), owner.node()) {}

void CostmapPorts::take(Navigator& navigator) {
  while (const auto call = clear_global_.take()) {
    navigator.clear_obstacles();
    clear_global_.reply(call->id, {});
  }
  while (const auto call = clear_local_.take()) {
    navigator.clear_obstacles();
    clear_local_.reply(call->id, {});
  }
}

void CostmapPorts::report(const Surroundings& surroundings,
                          const std::optional<geometry::Pose>& pose,
                          const builtin_interfaces::msg::Time& stamp, Time now) {
  const navigation::Grid& grid = surroundings.grid();
  if (is_due(next_global_, global_period, now) && global_.is_read()) {
    tell(global_, surroundings, {{0, 0}, grid.width, grid.height}, stamp);
  }
  if (pose && is_due(next_local_, local_period, now) && local_.is_read()) {
    tell(local_, surroundings, window_around(grid, position(*pose), local_side_m), stamp);
  }
}

template <class Topic>
void CostmapPorts::tell(Output<Topic>& output, const Surroundings& surroundings,
                        const navigation::CellWindow& window,
                        const builtin_interfaces::msg::Time& stamp) {
  auto message =
      grid_message(part_of(surroundings.grid(), window), surroundings.cost_percents(window));
  message.header().stamp(stamp);
  message.info().map_load_time(stamp);
  if (output.write(std::move(message)) == Status::failed) {
    log_.warn("{} was not sent", Topic::info.name);
  }
}

}  // namespace tocsin
