// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mapping/scan_matcher.hpp"

namespace tocsin::mapping {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using geometry::Pose;

constexpr int most_steps = 30;
constexpr double small_step = 1e-5;  // [m, rad]
/// Values below it tell nothing of how well a point fits: it lies on something else.
constexpr double fitting_value = 0.1;
/// Neighbouring beams share their errors; and the field is no better than this.
constexpr double independent_share = 0.25;
constexpr double floor_m = 0.01;
constexpr double floor_rad = 0.003;

/// Sum of (1 - M)^2 over the points and of the guess's terms, with its linearisation.
struct Cost {
  double value = 0;
  Matrix3d hessian = Matrix3d::Zero();
  Vector3d gradient = Vector3d::Zero();
  Matrix3d field_hessian = Matrix3d::Zero();  // without the guess
  double score = 0;                           // mean of M
  double fitting = 0;                         // number of points that fit
  double misfit = 0;                          // sum of (1 - M)^2 of those
};

class Refinement {
 public:
  Refinement(const LikelihoodField& field, const Points& points, const Pose& guess,
             const GuessTrust& trust)
      : field_(field), points_(points), guess_(guess) {
    // A point that fits has residuals of about this; so the trust has the points' unit.
    constexpr double usual_misfit = 0.1;
    weight_ = Vector3d(usual_misfit / (trust.distance_m * trust.distance_m),
                       usual_misfit / (trust.distance_m * trust.distance_m),
                       usual_misfit / (trust.turn_rad * trust.turn_rad));
  }

  [[nodiscard]] Cost cost(const Pose& pose) const {
    Cost cost;
    const double c = std::cos(pose.heading_rad);
    const double s = std::sin(pose.heading_rad);
    for (const auto& p : points_) {
      const double x = c * p.x_m - s * p.y_m;
      const double y = s * p.x_m + c * p.y_m;
      const auto m = field_.at(pose.x_m + x, pose.y_m + y);
      const double misfit = 1 - m.value;
      cost.value += misfit * misfit;
      cost.score += m.value;
      if (m.value < fitting_value) continue;
      const Vector3d slope(m.slope_x_per_m, m.slope_y_per_m,
                           -y * m.slope_x_per_m + x * m.slope_y_per_m);
      cost.field_hessian.noalias() += slope * slope.transpose();
      cost.gradient -= misfit * slope;
      cost.fitting += 1;
      cost.misfit += misfit * misfit;
    }
    if (!points_.empty()) cost.score /= static_cast<double>(points_.size());
    add_guess(pose, cost);
    return cost;
  }

 private:
  void add_guess(const Pose& pose, Cost& cost) const {
    const Vector3d off(pose.x_m - guess_.x_m, pose.y_m - guess_.y_m,
                       geometry::wrap_angle(pose.heading_rad - guess_.heading_rad));
    cost.value += off.dot(weight_.cwiseProduct(off));
    cost.gradient += weight_.cwiseProduct(off);
    cost.hessian = cost.field_hessian;
    cost.hessian.diagonal() += weight_;
  }

  const LikelihoodField& field_;
  const Points& points_;
  const Pose& guess_;
  Vector3d weight_;
};

/// Inverse of the covariance s^2 H^-1 + floor.
Matrix3d information_of(const Cost& cost) {
  if (cost.fitting < 10) return Matrix3d::Zero();
  const double variance = std::max(cost.misfit / cost.fitting, 0.01) / independent_share;
  Matrix3d information = cost.field_hessian / variance;
  information.diagonal() += Vector3d(1e-2, 1e-2, 1e-2);
  Matrix3d covariance = information.inverse();
  covariance.diagonal() += Vector3d(floor_m * floor_m, floor_m * floor_m, floor_rad * floor_rad);
  return covariance.inverse();
}

}  // namespace

Match refine(const LikelihoodField& field, const Points& points, const Pose& start,
             const Pose& guess, const GuessTrust& trust) {
  const Refinement refinement(field, points, guess, trust);
  Pose pose = start;
  Cost cost = refinement.cost(pose);
  double damping = 1e-3;
  for (int step = 0; step < most_steps && damping < 1e6; ++step) {
    Matrix3d damped = cost.hessian;
    damped.diagonal() *= 1 + damping;
    damped.diagonal().array() += 1e-9;
    const Vector3d move = -damped.ldlt().solve(cost.gradient);
    const Pose next{pose.x_m + move.x(), pose.y_m + move.y(),
                    geometry::wrap_angle(pose.heading_rad + move.z())};
    const Cost moved = refinement.cost(next);
    if (!(moved.value < cost.value)) {
      damping *= 10;
      continue;
    }
    pose = next;
    cost = moved;
    damping = std::max(damping * 0.1, 1e-6);
    if (move.cwiseAbs().maxCoeff() < small_step) break;
  }
  Match match;
  match.pose = pose;
  match.score = cost.score;
  match.information = information_of(cost);
  return match;
}

}  // namespace tocsin::mapping
