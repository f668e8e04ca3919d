// SPDX-License-Identifier: Apache-2.0
#include "localisation/scan_motion.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "foundation/numbers.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::localisation {
namespace {

using geometry::Pose;

constexpr double key_reach_m = 6;    // of the scan that is kept,
constexpr double hit_reach_m = 4.5;  // and of those that are matched with it: it shows more
constexpr double cell_m = 0.05;
constexpr double longest_way = 0.5;
constexpr std::size_t least_hits = 20;
constexpr double scan_witnesses = 40;  // more than of a map, which has not all that is seen
constexpr double slip_share = 0.6;     // of a step that wheels may lose, usual deviation
constexpr double usual_share = 0.05;   // what they err when they do not slip
constexpr double contradiction = 12;   // squared, in deviations; chance does it once in 130 times
constexpr double still_slipping = 2;   // the same where they slipped a moment ago

laser::Points within(const laser::Points& hits, double reach_m) {
  laser::Points near;
  std::copy_if(hits.begin(), hits.end(), std::back_inserter(near),
               [&](const geometry::Point& hit) { return std::hypot(hit.x_m, hit.y_m) < reach_m; });
  return near;
}

DistanceMap map_of(const laser::Points& hits) {
  constexpr int side = static_cast<int>(2 * (key_reach_m + 1) / cell_m);
  const navigation::Grid grid{side, side, cell_m, {-key_reach_m - 1, -key_reach_m - 1}};
  std::vector<navigation::Cell> cells(grid.size(), navigation::Cell::free);
  for (const geometry::Point& hit : laser::joined(within(hits, key_reach_m), cell_m)) {
    if (const auto cell = grid.cell_of(hit)) cells[grid.offset(*cell)] = navigation::Cell::occupied;
  }
  return DistanceMap({grid, std::move(cells)});
}

/// Hits that are not of somebody who stands close.
laser::Points far_of(const laser::Points& hits) {
  constexpr double close_m = 0.7;
  laser::Points far;
  std::copy_if(hits.begin(), hits.end(), std::back_inserter(far),
               [](const geometry::Point& hit) { return std::hypot(hit.x_m, hit.y_m) > close_m; });
  return far;
}

double seen_before(const DistanceMap& key, const laser::Points& hits, const Pose& pose) {
  constexpr double seen_m = 0.15;
  const laser::Points placed = laser::transformed(far_of(hits), pose);
  const auto count = std::count_if(placed.begin(), placed.end(), [&](const geometry::Point& hit) {
    return key.nearest_m(hit) < seen_m;
  });
  return static_cast<double>(count) / static_cast<double>(placed.size());
}

/// Deviations of a step if so much of it may be wrong.
Eigen::Vector3d deviations(const Pose& step, double share) {
  const double way_m = std::hypot(step.x_m, step.y_m);
  const double turn_rad = std::abs(step.heading_rad);
  return {share * way_m + 0.003, share * way_m + 0.003, share * turn_rad + 0.03 * way_m + 0.003};
}

}  // namespace

/// Whether somebody stands so close that the scan shows little of what is around.
bool ScanMotion::is_hidden(const laser::Points& hits) const {
  return static_cast<double>(far_of(hits).size()) < 0.6 * usual_hits_;
}

void ScanMotion::begin(const laser::Points& hits) {
  was_slipping_ = std::exchange(is_slipping_, false);
  key_.reset();
  by_scans_ = {};
  by_scans_.covariance = Eigen::Vector3d(1e-6, 1e-6, 1e-6).asDiagonal();
  by_wheels_ = told_ = {};
  way_ = 0;
  if (!is_hidden(hits) && within(hits, key_reach_m).size() >= least_hits) {
    key_.emplace(map_of(hits));
  }
}

ScanMotion::Step ScanMotion::on_scan(const laser::Points& hits, const Pose& odometry) {
  Step result{odometry, std::nullopt, 1};
  const laser::Points near = within(hits, hit_reach_m);
  usual_hits_ = std::max(static_cast<double>(hits.size()), 0.99 * usual_hits_);
  const bool is_hidden = this->is_hidden(hits) || far_of(near).size() < least_hits;
  if (key_ && near.size() >= least_hits) {
    const Eigen::Vector3d loose = deviations(odometry, slip_share);
    by_scans_.pose = compose(by_scans_.pose, odometry);
    by_scans_.covariance.diagonal() += loose.cwiseAbs2();
    by_scans_ = match(*key_, near, by_scans_, scan_witnesses);
    if (!is_hidden) result.seen_before = seen_before(*key_, near, by_scans_.pose);
    by_wheels_ = compose(by_wheels_, odometry);
    way_ += std::hypot(odometry.x_m, odometry.y_m) + std::abs(odometry.heading_rad);
    const Pose off = relative(by_wheels_, by_scans_.pose);
    Eigen::Matrix3d together = by_scans_.covariance;
    together.diagonal() += deviations(by_wheels_, usual_share).cwiseAbs2();
    const Eigen::Vector3d miss(off.x_m, off.y_m, off.heading_rad);
    const Pose before = told_;
    is_slipping_ =
        miss.dot(together.inverse() * miss) > (was_slipping_ ? still_slipping : contradiction);
    if (is_slipping_) {
      told_ = by_scans_.pose;
      result.step = relative(before, told_);
      result.covariance = by_scans_.covariance;
    } else {
      told_ = compose(told_, odometry);
    }
  }
  if (!key_ || way_ > longest_way || near.size() < least_hits) begin(hits);
  return result;
}

}  // namespace tocsin::localisation
