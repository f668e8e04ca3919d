// SPDX-License-Identifier: Apache-2.0
#include "mapping/local_mapper.hpp"

#include <cmath>
#include <utility>

namespace tocsin::mapping {

using geometry::compose;
using geometry::Pose;

LocalMapper::LocalMapper(const LocalParams& params, std::optional<Pose> start,
                         std::size_t first_node)
    : params_(params), start_(start), next_node_(first_node) {}

bool LocalMapper::has_moved(const Pose& odometry) const {
  if (!last_) return true;
  const Pose step = relative(last_->odometry, odometry);
  return std::hypot(step.x_m, step.y_m) >= params_.step_m ||
         std::abs(step.heading_rad) >= params_.step_rad;
}

Pose LocalMapper::pose_at(const Pose& odometry) const {
  if (!last_) return start_.value_or(odometry);
  return compose(last_->pose, odometry_.corrected(relative(last_->odometry, odometry)));
}

void LocalMapper::on_new_odometry(const Pose& before, const Pose& now) {
  if (last_) last_->odometry = compose(now, inverse(relative(last_->odometry, before)));
}

std::optional<LocalStep> LocalMapper::on_scan(const Pose& odometry, Scan scan) {
  if (!has_moved(odometry)) return std::nullopt;
  LocalStep node;
  node.odometry = odometry;
  node.pose = pose_at(odometry);
  node.scan = std::move(scan);
  if (last_) place(node);
  insert(node);
  last_ = {odometry, node.pose};
  ++next_node_;
  return node;
}

Match LocalMapper::match(const Growing& target, const Points& thin, const Pose& pose,
                         const Pose& step) const {
  const Pose guess = relative(target.first, pose);
  const GuessTrust trust = OdometryModel::trust(step);
  const LikelihoodField& field = target.submap.field();
  const Match near = refine(field, thin, guess, guess, trust);
  if (is_sure(near, guess, field, params_.sure_score)) return near;
  SearchParams search_params;
  search_params.min_score = params_.min_score - params_.guess_weight * 3;
  search_params.guess_weight = params_.guess_weight;
  const auto found =
      search(target.submap.bounds(), thin, guess, OdometryModel::window(step), search_params);
  if (!found) return {};
  return refine(field, thin, found->pose, guess, trust);
}

void LocalMapper::place(LocalStep& node) {
  const Pose measured = relative(last_->odometry, node.odometry);
  const Pose step = relative(last_->pose, node.pose);
  node.constraints.push_back(
      {next_node_ - 1, next_node_, step, OdometryModel::information(step), false});
  const Growing& target = growing_.front();
  const Match found =
      match(target, laser::thinned(node.scan.hits, params_.thin_m), node.pose, step);
  node.matched = found.score >= params_.min_score;
  if (!node.matched) return;
  node.pose = compose(target.first, found.pose);
  odometry_.learn(measured, relative(last_->pose, node.pose));
  for (const Growing& growing : growing_) {
    node.constraints.push_back({growing.submap.first_node(), next_node_,
                                relative(growing.first, node.pose), found.information, false});
  }
}

void LocalMapper::insert(LocalStep& node) {
  if (growing_.empty() || growing_.back().submap.nodes().size() >= params_.submap_scans / 2) {
    growing_.push_back({node.pose, Submap(next_node_, params_.resolution_m, params_.sigma_m)});
  }
  for (Growing& growing : growing_) {
    growing.submap.insert(next_node_, node.scan, relative(growing.first, node.pose));
  }
  while (growing_.front().submap.nodes().size() >= params_.submap_scans) {
    growing_.front().submap.finish();
    node.finished.push_back(std::move(growing_.front().submap));
    growing_.pop_front();
  }
}

std::vector<Submap> LocalMapper::finish() {
  std::vector<Submap> finished;
  for (Growing& growing : growing_) {
    growing.submap.finish();
    finished.push_back(std::move(growing.submap));
  }
  growing_.clear();
  return finished;
}

}  // namespace tocsin::mapping
