// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mapping/scan_matcher.hpp"

namespace tocsin::mapping {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using geometry::Pose;

constexpr int most_steps = 30;
constexpr double small_step = 1e-5;  // [m, rad]
/// Fewer points tell nothing of a pose.
constexpr double least_fitting = 10;
/// Neighbouring beams share their errors; and the field is no better than this.
constexpr double independent_share = 0.25;
constexpr double floor_m = 0.01;
constexpr double floor_rad = 0.003;

/// Minus the second derivatives of the field, over a distance at which a wall is seen as one,
/// without what is not positive. At a wall that is M n n' / sigma^2 with its normal n: the Hessian
/// of Gauss-Newton for the distance to the wall with the robust weight M (Welsch).
Matrix2d curvature(const LikelihoodField& field, double x_m, double y_m) {
  const auto field_s = field.curvature_at(x_m, y_m);
  const double xx = -field_s.xx;
  const double yy = -field_s.yy;
  const double xy = -field_s.xy;
  // Eigenvalues of the symmetric matrix; the negative ones are taken out.
  const double mean = (xx + yy) / 2;
  const double spread = std::hypot((xx - yy) / 2, xy);
  Matrix2d whole;
  whole << xx, xy, xy, yy;
  if (mean >= spread) return whole;
  if (mean + spread <= 0 || spread == 0) return Matrix2d::Zero();
  // What is left of the larger one: its projection.
  Matrix2d projection = whole;
  projection.diagonal().array() -= mean - spread;
  return projection * ((mean + spread) / (2 * spread));
}

/// What the points lose by not lying on the field, and what the guess adds, with derivatives.
struct Cost {
  double value = 0;
  Vector3d gradient = Vector3d::Zero();
  double score = 0;  // mean of M
};

class Refinement {
 public:
  Refinement(const LikelihoodField& field, const Points& points, const Pose& guess,
             const GuessTrust& trust)
      : field_(field), points_(points), guess_(guess) {
    const double place = 1 / (trust.distance_m * trust.distance_m);
    weight_ = Vector3d(place, place, 1 / (trust.turn_rad * trust.turn_rad));
  }

  [[nodiscard]] Cost cost(const Pose& pose) const {
    Cost cost;
    const double c = std::cos(pose.heading_rad);
    const double s = std::sin(pose.heading_rad);
    for (const auto& p : points_) {
      const double x = c * p.x_m - s * p.y_m;
      const double y = s * p.x_m + c * p.y_m;
      const auto m = field_.at(pose.x_m + x, pose.y_m + y);
      cost.score += m.value;
      cost.gradient -=
          Vector3d(m.slope_x_per_m, m.slope_y_per_m, -y * m.slope_x_per_m + x * m.slope_y_per_m);
    }
    const Vector3d off(pose.x_m - guess_.x_m, pose.y_m - guess_.y_m,
                       geometry::wrap_angle(pose.heading_rad - guess_.heading_rad));
    cost.value = -cost.score + off.dot(weight_.cwiseProduct(off)) / 2;
    cost.gradient += weight_.cwiseProduct(off);
    if (!points_.empty()) cost.score /= static_cast<double>(points_.size());
    return cost;
  }

  /// Of the points alone.
  [[nodiscard]] Matrix3d hessian(const Pose& pose) const {
    Matrix3d sum = Matrix3d::Zero();
    const double c = std::cos(pose.heading_rad);
    const double s = std::sin(pose.heading_rad);
    for (const auto& p : points_) {
      const double x = c * p.x_m - s * p.y_m;
      const double y = s * p.x_m + c * p.y_m;
      const Matrix2d k = curvature(field_, pose.x_m + x, pose.y_m + y);
      const Eigen::Vector2d turned = k * Eigen::Vector2d(-y, x);
      sum.topLeftCorner<2, 2>() += k;
      sum.block<2, 1>(0, 2) += turned;
      sum.block<1, 2>(2, 0) += turned.transpose();
      sum(2, 2) += -y * turned.x() + x * turned.y();
    }
    return sum;
  }

  [[nodiscard]] const Vector3d& weight() const { return weight_; }

 private:
  const LikelihoodField& field_;
  const Points& points_;
  const Pose& guess_;
  Vector3d weight_;
};

Matrix3d information_of(const Matrix3d& hessian) {
  Matrix3d information = hessian * independent_share;
  information.diagonal().array() += 1e-2;
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
  Matrix3d hessian = refinement.hessian(pose);
  double damping = 1e-3;
  for (int step = 0; step < most_steps && damping < 1e6; ++step) {
    Matrix3d damped = hessian;
    damped.diagonal() = (damped.diagonal() + refinement.weight()) * (1 + damping);
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
    hessian = refinement.hessian(pose);
    damping = std::max(damping * 0.1, 1e-6);
    if (move.cwiseAbs().maxCoeff() < small_step) break;
  }
  Match match;
  match.pose = pose;
  match.score = cost.score;
  const double fitting = cost.score * static_cast<double>(points.size());
  if (fitting >= least_fitting) match.information = information_of(hessian);
  return match;
}

bool is_sure(const Match& match, const Pose& guess, const LikelihoodField& field,
             double sure_score) {
  return match.score >= sure_score &&
         geometry::distance(position(match.pose), position(guess)) <= field.sigma_m();
}

}  // namespace tocsin::mapping
