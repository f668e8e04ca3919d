// SPDX-License-Identifier: Apache-2.0
#include "replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "mapping/spread_misfit.hpp"

namespace tocsin::map_tool {

using geometry::compose;
using geometry::Pose;

Replay::Replay(const mapping::MapperParams& params, const laser::ScanParams& scan_params)
    : scan_params_(scan_params), mapper_(params) {}

void Replay::on_reading(const LogReading& reading) {
  bool is_node = false;
  if (reading.scan) {
    ++scans_;
    laser::ScanParams params = scan_params_;
    params.max_range_m = std::min(params.max_range_m, reading.scan->max_range_m);
    is_node = mapper_.on_scan(reading.odometry,
                              make_scan(reading.scan->ranges_m, reading.scan->beams, params));
  }
  if (!readings_.empty() && readings_.back().time_s == reading.time_s) {
    // A scan and the odometry of the same instant are one reading.
    readings_.back() = {reading.time_s, reading.odometry, is_node || readings_.back().is_node};
    return;
  }
  readings_.push_back({reading.time_s, reading.odometry, is_node});
}

void Replay::add_between(const std::vector<Reading>& readings, std::size_t node,
                         std::vector<TimedPose>& trajectory) const {
  // Before the first node, and after the last one, the odometry alone leads.
  const auto& nodes = mapper_.nodes();
  const auto& poses = mapper_.poses();
  if (node == 0 || node == nodes.size()) {
    const std::size_t from = node == 0 ? 0 : node - 1;
    for (const Reading& reading : readings) {
      const Pose way = relative(nodes[from].odometry, reading.odometry);
      trajectory.push_back({reading.time_s, compose(poses[from], way)});
    }
    return;
  }
  std::vector<Pose> odometry{nodes[node - 1].odometry};
  for (const Reading& reading : readings) odometry.push_back(reading.odometry);
  const auto between = mapping::spread_misfit(odometry, poses[node - 1], poses[node]);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    trajectory.push_back({readings[i].time_s, between[i + 1]});
  }
}

std::vector<TimedPose> Replay::trajectory() const {
  std::vector<TimedPose> trajectory;
  std::vector<Reading> waiting;
  if (mapper_.nodes().empty()) {
    for (const Reading& r : readings_) trajectory.push_back({r.time_s, r.odometry});
    return trajectory;
  }
  std::size_t node = 0;
  for (const Reading& reading : readings_) {
    waiting.push_back(reading);
    if (!reading.is_node) continue;
    add_between(waiting, node++, trajectory);
    waiting.clear();
  }
  add_between(waiting, node, trajectory);
  return trajectory;
}

std::string trajectory_text(const std::vector<TimedPose>& trajectory) {
  std::string text;
  for (const auto& [time_s, pose] : trajectory) {
    fmt::format_to(std::back_inserter(text), "{:.6f} {:.6f} {:.6f} {:.6f}\n", time_s, pose.x_m,
                   pose.y_m, pose.heading_rad);
  }
  return text;
}

}  // namespace tocsin::map_tool
