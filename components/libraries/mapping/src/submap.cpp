// SPDX-License-Identifier: Apache-2.0
#include "mapping/submap.hpp"

#include <algorithm>
#include <cassert>

namespace tocsin::mapping {

Submap::Submap(std::size_t first_node, double resolution_m, double sigma_m)
    : first_node_(first_node),

      occupancy_(resolution_m),
      field_(resolution_m, sigma_m) {}

void Submap::insert(std::size_t node, const Scan& scan, const geometry::Pose& pose) {
  nodes_.push_back(node);
  poses_.push_back(pose);
  const Points hits = laser::transformed(laser::joined(scan.hits, field_.sigma_m()), pose);
  points_.insert(points_.end(), hits.begin(), hits.end());
  occupancy_.insert(scan, pose);
  bounds_.reset();
  field_.stamp(hits);
}

void Submap::finish() {
  const auto has_gone = [&](const geometry::Point& p) {
    return occupancy_.at(p) == navigation::Cell::free;
  };
  points_.erase(std::remove_if(points_.begin(), points_.end(), has_gone), points_.end());
  bounds_.reset();
  field_ = LikelihoodField(field_.grid().resolution_m, field_.sigma_m());
  field_.stamp(points_);
  points_ = {};
  keep_free_cells();
  finished_ = true;
}

void Submap::keep_free_cells() {
  const navigation::OccupancyMap known = occupancy_.map();
  free_grid_ = known.grid();
  free_.clear();
  free_.reserve(free_grid_.size());
  for (const auto cell : known.cells()) free_.push_back(cell == navigation::Cell::free);
  occupancy_ = OccupancyGrid(field_.grid().resolution_m);
}

bool Submap::is_free(const geometry::Point& p) const {
  const auto cell = free_grid_.cell_of(p);
  return cell && free_[free_grid_.offset(*cell)];
}

void Submap::rebuild(const std::vector<const Scan*>& scans,
                     const std::vector<geometry::Pose>& poses) {
  const std::vector<std::size_t> nodes = std::move(nodes_);
  nodes_.clear();
  poses_.clear();
  const double resolution_m = field_.grid().resolution_m;
  occupancy_ = OccupancyGrid(resolution_m);
  field_ = LikelihoodField(resolution_m, field_.sigma_m());
  for (std::size_t i = 0; i < nodes.size(); ++i) insert(nodes[i], *scans[i], poses[i]);
  finish();
}

bool Submap::contains(std::size_t node) const {
  return std::binary_search(nodes_.begin(), nodes_.end(), node);
}

const FieldBounds& Submap::bounds() const {
  if (!bounds_) bounds_ = std::make_unique<FieldBounds>(field_);
  return *bounds_;
}

Agreement Submap::agreement(const Points& points, const geometry::Pose& pose) const {
  constexpr double explained = 0.1;  // within about two sigma of a point
  assert(finished_);
  double seen = 0;
  double opposed = 0;
  for (const auto& p : laser::transformed(points, pose)) {
    const bool is_explained = field_.at(p.x_m, p.y_m).value > explained;
    const bool nothing_is_there = is_free(p);
    if (is_explained || nothing_is_there) ++seen;
    if (nothing_is_there && !is_explained) ++opposed;
  }
  if (seen == 0) return {};
  return {seen / static_cast<double>(points.size()), opposed / seen};
}

}  // namespace tocsin::mapping
