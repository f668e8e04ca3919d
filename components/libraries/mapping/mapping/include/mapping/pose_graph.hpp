// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "geometry/pose.hpp"

namespace tocsin::mapping {

/// What is believed of the pose of one node in the frame of another.
struct Constraint {
  std::size_t from = 0;
  std::size_t to = 0;
  geometry::Pose relative;  ///< of `to` in the frame of `from`
  /// Inverse covariance of `relative` [1/m^2, 1/rad^2]; symmetric, not negative.
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
  /// May be wrong (a place recognised), so it loses its weight when it contradicts the others.
  bool may_be_wrong = false;
};

struct SolveParams {
  /// Squared error, in units of the covariance, at which a constraint that may be wrong has a
  /// quarter of its weight (Geman and McClure).
  double doubted_error = 30.0;
  /// Begins by trusting all constraints and doubts more with each step (graduated non-convexity:
  /// Yang et al., RA-L 2020): for constraints that move the graph far. Else it doubts at once.
  bool graduated = true;
  int most_steps = 60;
  double small_step = 5e-4;  ///< [m, rad] ends when no node moves more
};

/// Poses that agree best with what is believed of pairs of them: Gauss-Newton with a sparse
/// Cholesky decomposition. Deterministic. Node 0 stays where it is.
class PoseGraph {
 public:
  /// Returns the index of the node.
  std::size_t add_node(const geometry::Pose& pose);
  /// Asserts that both nodes are there and differ.
  void add(const Constraint& constraint);

  /// Moves the nodes; returns the number of steps it took. Nodes that no constraint ties to node 0
  /// stay where they are.
  int solve(const SolveParams& params = {});

  [[nodiscard]] const std::vector<geometry::Pose>& poses() const { return poses_; }
  [[nodiscard]] const std::vector<Constraint>& constraints() const { return constraints_; }
  /// Squared error of a constraint in units of its covariance.
  [[nodiscard]] double error_of(const Constraint& constraint) const;
  /// Leaves out all constraints that may be wrong.
  void drop_doubtful();

 private:
  struct Linear;
  [[nodiscard]] double largest_doubtful_error() const;
  /// One step of Gauss-Newton; returns the largest move [m, rad].
  double step(Linear& linear, double doubted_error);

  std::vector<geometry::Pose> poses_;
  std::vector<Constraint> constraints_;
};

}  // namespace tocsin::mapping
