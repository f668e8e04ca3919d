// SPDX-License-Identifier: Apache-2.0
#include "mapping/pose_graph.hpp"

#include <Eigen/Sparse>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace tocsin::mapping {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using geometry::Pose;
using Index = Eigen::Index;

/// Ties every node to where it is, too weakly to be felt by one that a constraint holds.
constexpr double loose_tie = 1e-6;
constexpr double fixed = 1e12;
constexpr double step_of_doubt = 2.0;

Vector3d misfit(const Constraint& constraint, const std::vector<Pose>& poses) {
  const Pose is = relative(poses[constraint.from], poses[constraint.to]);
  return {is.x_m - constraint.relative.x_m, is.y_m - constraint.relative.y_m,
          geometry::wrap_angle(is.heading_rad - constraint.relative.heading_rad)};
}

/// Derivatives of the misfit by the poses of both nodes.
struct Slopes {
  Matrix3d from;
  Matrix3d to;
};

Slopes slopes(const Pose& from, const Pose& to) {
  const double c = std::cos(from.heading_rad);
  const double s = std::sin(from.heading_rad);
  const double dx = to.x_m - from.x_m;
  const double dy = to.y_m - from.y_m;
  Slopes slopes;
  slopes.from << -c, -s, -s * dx + c * dy, s, -c, -c * dx - s * dy, 0, 0, -1;
  slopes.to << c, s, 0, -s, c, 0, 0, 0, 1;
  return slopes;
}

}  // namespace

/// The linear system of a step. Its pattern is the same in all steps of a solve.
struct PoseGraph::Linear {
  explicit Linear(std::size_t nodes)
      : size(static_cast<Index>(3 * nodes)), matrix(size, size), right(size) {}

  void add_block(std::size_t row, std::size_t column, const Matrix3d& block) {
    const auto i = static_cast<int>(3 * row);
    const auto j = static_cast<int>(3 * column);
    for (int k = 0; k < 3; ++k) {
      for (int l = 0; l < 3; ++l) {
        if (i + k >= j + l) entries.emplace_back(i + k, j + l, block(k, l));
      }
    }
  }

  Eigen::VectorXd solve() {
    matrix.setFromTriplets(entries.begin(), entries.end());
    if (!analysed) solver.analyzePattern(matrix);
    analysed = true;
    solver.factorize(matrix);
    return solver.solve(right);
  }

  Index size;
  Eigen::SparseMatrix<double> matrix;
  Eigen::VectorXd right;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
  bool analysed = false;
};

std::size_t PoseGraph::add_node(const Pose& pose) {
  poses_.push_back(pose);
  return poses_.size() - 1;
}

void PoseGraph::add(const Constraint& constraint) {
  assert(constraint.from < poses_.size() && constraint.to < poses_.size());
  assert(constraint.from != constraint.to);
  constraints_.push_back(constraint);
}

double PoseGraph::error_of(const Constraint& constraint) const {
  const Vector3d off = misfit(constraint, poses_);
  return off.dot(constraint.information * off);
}

double PoseGraph::largest_doubtful_error() const {
  double largest = 0;
  for (const Constraint& c : constraints_) {
    if (c.may_be_wrong) largest = std::max(largest, error_of(c));
  }
  return largest;
}

void PoseGraph::drop_doubtful() {
  const auto is_doubtful = [](const Constraint& c) { return c.may_be_wrong; };
  constraints_.erase(std::remove_if(constraints_.begin(), constraints_.end(), is_doubtful),
                     constraints_.end());
}

double PoseGraph::step(Linear& linear, double doubted_error) {
  linear.entries.clear();
  linear.right.setZero();
  for (const Constraint& c : constraints_) {
    const Vector3d off = misfit(c, poses_);
    const double error = off.dot(c.information * off);
    const double trust = doubted_error / (doubted_error + error);
    const Matrix3d weight =
        c.may_be_wrong ? Matrix3d(c.information * (trust * trust)) : c.information;
    const Slopes s = slopes(poses_[c.from], poses_[c.to]);
    const Matrix3d from_weight = s.from.transpose() * weight;
    const Matrix3d to_weight = s.to.transpose() * weight;
    linear.add_block(c.from, c.from, from_weight * s.from);
    linear.add_block(c.to, c.to, to_weight * s.to);
    if (c.from > c.to) linear.add_block(c.from, c.to, from_weight * s.to);
    if (c.to > c.from) linear.add_block(c.to, c.from, to_weight * s.from);
    linear.right.segment<3>(static_cast<Index>(3 * c.from)) -= from_weight * off;
    linear.right.segment<3>(static_cast<Index>(3 * c.to)) -= to_weight * off;
  }
  linear.add_block(0, 0, Matrix3d::Identity() * fixed);
  for (std::size_t i = 1; i < poses_.size(); ++i) {
    linear.add_block(i, i, Matrix3d::Identity() * loose_tie);
  }
  const Eigen::VectorXd move = linear.solve();
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const auto k = static_cast<Index>(3 * i);
    poses_[i] = {poses_[i].x_m + move[k], poses_[i].y_m + move[k + 1],
                 geometry::wrap_angle(poses_[i].heading_rad + move[k + 2])};
  }
  return move.cwiseAbs().maxCoeff();
}

int PoseGraph::solve(const SolveParams& params) {
  if (poses_.size() < 2) return 0;
  Linear linear(poses_.size());
  double doubted_error = params.doubted_error;
  if (params.graduated) doubted_error = std::max(doubted_error, 2 * largest_doubtful_error());
  for (int i = 1; i <= params.most_steps; ++i) {
    const double moved = step(linear, doubted_error);
    if (doubted_error <= params.doubted_error && moved < params.small_step) return i;
    doubted_error = std::max(doubted_error / step_of_doubt, params.doubted_error);
  }
  return params.most_steps;
}

}  // namespace tocsin::mapping
