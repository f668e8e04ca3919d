// SPDX-License-Identifier: Apache-2.0
#include "mapping/local_mapper.hpp"

#include <cmath>
#include <utility>

#include "mapping/relative_pose.hpp"

namespace tocsin::mapping {

using geometry::compose;
using geometry::Pose;

LocalMapper::LocalMapper(const LocalParams& params) : params_(params) {}

bool LocalMapper::has_moved(const Pose& odometry) const {
  if (nodes_.empty()) return true;
  const Pose step = relative(nodes_.back().odometry, odometry);
  return std::hypot(step.x_m, step.y_m) >= params_.step_m ||
         std::abs(step.heading_rad) >= params_.step_rad;
}

Pose LocalMapper::pose_at(const Pose& odometry) const {
  if (nodes_.empty()) return odometry;
  const Node& last = nodes_.back();
  return compose(last.pose, odometry_.corrected(relative(last.odometry, odometry)));
}

Pose LocalMapper::in_submap(const Submap& submap, const Pose& pose) const {
  return relative(nodes_[submap.first_node()].pose, pose);
}

const Submap& LocalMapper::target() const {
  const bool two_grow = submaps_.size() > 1 && !submaps_[submaps_.size() - 2].is_finished();
  return two_grow ? submaps_[submaps_.size() - 2] : submaps_.back();
}

std::optional<std::vector<Constraint>> LocalMapper::on_scan(const Pose& odometry, Scan scan) {
  if (!has_moved(odometry)) return std::nullopt;
  Node node;
  node.odometry = odometry;
  node.pose = pose_at(odometry);
  node.thin = laser::thinned(scan.hits, params_.thin_m);
  node.scan = std::move(scan);
  std::vector<Constraint> constraints;
  if (!nodes_.empty()) place(node, constraints);
  nodes_.push_back(std::move(node));
  insert(nodes_.back());
  return constraints;
}

Match LocalMapper::match(const Submap& submap, const Node& node, const Pose& step) const {
  const Pose guess = in_submap(submap, node.pose);
  SearchParams search_params;
  search_params.min_score = params_.min_score - params_.guess_weight * 3;
  search_params.guess_weight = params_.guess_weight;
  const auto found =
      search(submap.bounds(), node.thin, guess, OdometryModel::window(step), search_params);
  if (!found) return {};
  return refine(submap.field(), node.thin, found->pose, guess, OdometryModel::trust(step));
}

void LocalMapper::place(Node& node, std::vector<Constraint>& constraints) {
  const Node& last = nodes_.back();
  const std::size_t index = nodes_.size();
  const Pose measured = relative(last.odometry, node.odometry);
  const Pose step = relative(last.pose, node.pose);
  constraints.push_back({index - 1, index, step, OdometryModel::information(step), false});
  const Match match = this->match(target(), node, step);
  node.matched = match.score >= params_.min_score;
  if (!node.matched) return;
  node.pose = compose(nodes_[target().first_node()].pose, match.pose);
  odometry_.learn(measured, relative(last.pose, node.pose));
  for (const Submap& submap : submaps_) {
    if (submap.is_finished()) continue;
    constraints.push_back(
        {submap.first_node(), index, in_submap(submap, node.pose), match.information, false});
  }
}

void LocalMapper::insert(const Node& node) {
  const std::size_t index = nodes_.size() - 1;
  const std::size_t half = params_.submap_scans / 2;
  if (submaps_.empty() || submaps_.back().nodes().size() >= half) {
    submaps_.emplace_back(index, params_.resolution_m, params_.sigma_m);
  }
  for (std::size_t i = submaps_.size() > 2 ? submaps_.size() - 3 : 0; i < submaps_.size(); ++i) {
    Submap& submap = submaps_[i];
    if (submap.is_finished()) continue;
    submap.insert(index, node.scan, in_submap(submap, node.pose));
    if (submap.nodes().size() >= params_.submap_scans) submap.finish();
  }
}

void LocalMapper::finish() {
  for (Submap& submap : submaps_) {
    if (!submap.is_finished()) submap.finish();
  }
}

void LocalMapper::rebuild(const std::vector<Pose>& poses) {
  for (Submap& submap : submaps_) {
    std::vector<const Scan*> scans;
    std::vector<Pose> in_submap;
    for (const std::size_t node : submap.nodes()) {
      scans.push_back(&nodes_[node].scan);
      in_submap.push_back(relative(poses[submap.first_node()], poses[node]));
    }
    submap.rebuild(scans, in_submap);
  }
}

}  // namespace tocsin::mapping
