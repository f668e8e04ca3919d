// SPDX-License-Identifier: Apache-2.0
#include "mapping/submap.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tocsin::mapping {

Submap::Submap(std::size_t first_node, double resolution_m, double sigma_m)
    : first_node_(first_node),
      resolution_m_(resolution_m),
      sigma_m_(sigma_m),
      occupancy_(resolution_m),
      field_(std::make_unique<LikelihoodField>(resolution_m, sigma_m)) {}

void Submap::insert(std::size_t node, const Scan& scan, const geometry::Pose& pose) {
  nodes_.push_back(node);
  poses_.push_back(pose);
  const Points hits = laser::transformed(laser::joined(scan.hits, sigma_m_), pose);
  points_.insert(points_.end(), hits.begin(), hits.end());
  occupancy_.insert(scan, pose);
  bounds_.reset();
  field_->stamp(hits);
}

void Submap::finish() {
  finished_ = true;
  rest();
  keep_places();
  keep_free_cells();
}

void Submap::keep_places() {
  const double place_m = resolution_m_ / LikelihoodField::places;
  places_.clear();
  for (const geometry::Point& p : points_) {
    if (occupancy_.at(p) == navigation::Cell::free) continue;
    places_.push_back({static_cast<int>(std::floor(p.x_m / place_m)),
                       static_cast<int>(std::floor(p.y_m / place_m))});
  }
  std::sort(places_.begin(), places_.end());
  places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
  places_.shrink_to_fit();
  points_ = {};
}

const LikelihoodField& Submap::field() const {
  if (field_) return *field_;
  const double place_m = resolution_m_ / LikelihoodField::places;
  Points points;
  points.reserve(places_.size());
  for (const Place& place : places_) {
    points.push_back({(place.x + 0.5) * place_m, (place.y + 0.5) * place_m});
  }
  field_ = std::make_unique<LikelihoodField>(resolution_m_, sigma_m_);
  field_->stamp(points);
  return *field_;
}

void Submap::rest() const {
  assert(finished_);
  bounds_.reset();
  field_.reset();
}

void Submap::keep_free_cells() {
  const navigation::OccupancyMap known = occupancy_.map();
  free_grid_ = known.grid();
  free_.clear();
  free_.reserve(free_grid_.size());
  for (const auto cell : known.cells()) free_.push_back(cell == navigation::Cell::free);
  occupancy_ = OccupancyGrid(resolution_m_);
}

bool Submap::is_free(const geometry::Point& p) const {
  const auto cell = free_grid_.cell_of(p);
  return cell && free_[free_grid_.offset(*cell)];
}

void Submap::rebuild(const std::vector<Scan>& scans, const std::vector<geometry::Pose>& poses) {
  const std::vector<std::size_t> nodes = std::move(nodes_);
  nodes_.clear();
  poses_.clear();
  field_ = std::make_unique<LikelihoodField>(resolution_m_, sigma_m_);
  for (std::size_t i = 0; i < nodes.size(); ++i) insert(nodes[i], scans[i], poses[i]);
  finish();
}

bool Submap::contains(std::size_t node) const {
  return std::binary_search(nodes_.begin(), nodes_.end(), node);
}

const FieldBounds& Submap::bounds() const {
  if (!bounds_) bounds_ = std::make_unique<FieldBounds>(field());
  return *bounds_;
}

Agreement Submap::agreement(const Points& points, const geometry::Pose& pose) const {
  constexpr double explained = 0.1;  // within about two sigma of a point
  assert(finished_);
  const LikelihoodField& field = this->field();
  double seen = 0;
  double opposed = 0;
  for (const auto& p : laser::transformed(points, pose)) {
    const bool is_explained = field.at(p.x_m, p.y_m).value > explained;
    const bool nothing_is_there = is_free(p);
    if (is_explained || nothing_is_there) ++seen;
    if (nothing_is_there && !is_explained) ++opposed;
  }
  if (seen == 0) return {};
  return {seen / static_cast<double>(points.size()), opposed / seen};
}

}  // namespace tocsin::mapping
