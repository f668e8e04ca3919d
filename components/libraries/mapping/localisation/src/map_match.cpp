// SPDX-License-Identifier: Apache-2.0
#include "localisation/map_match.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace tocsin::localisation {
namespace {

constexpr int most_steps = 10;
constexpr double scale_m = 0.1;
constexpr double other_m = 0.5;
constexpr double deviation_m = 0.05;

struct Normal {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double used = 0;
};

Normal normal_at(const DistanceMap& map, const laser::Points& hits, const geometry::Pose& pose) {
  const double c = std::cos(pose.heading_rad);
  const double s = std::sin(pose.heading_rad);
  Normal normal;
  for (const geometry::Point& hit : hits) {
    const geometry::Point at{pose.x_m + c * hit.x_m - s * hit.y_m,
                             pose.y_m + s * hit.x_m + c * hit.y_m};
    const DistanceMap::Sample sample = map.sample(at);
    if (sample.distance_m >= other_m) continue;
    const double ratio = sample.distance_m / scale_m;
    const double weight = 1 / (1 + ratio * ratio);
    const Eigen::Vector3d slope(
        sample.dx, sample.dy,
        sample.dx * (-s * hit.x_m - c * hit.y_m) + sample.dy * (c * hit.x_m - s * hit.y_m));
    normal.information += weight * slope * slope.transpose();
    normal.gradient += weight * sample.distance_m * slope;
    normal.used += weight;
  }
  return normal;
}

}  // namespace

Belief match(const DistanceMap& map, const laser::Points& hits, const Belief& before,
             double witnesses) {
  const Eigen::Matrix3d prior = before.covariance.inverse();
  Belief belief = before;
  Eigen::Matrix3d information = prior;
  for (int step = 0; step < most_steps; ++step) {
    const Normal normal = normal_at(map, hits, belief.pose);
    const double count = std::max<double>(1, static_cast<double>(hits.size()));
    const double share = witnesses / count / (deviation_m * deviation_m);
    const Eigen::Vector3d off(
        belief.pose.x_m - before.pose.x_m, belief.pose.y_m - before.pose.y_m,
        geometry::wrap_angle(belief.pose.heading_rad - before.pose.heading_rad));
    information = prior + share * normal.information;
    const Eigen::Vector3d move = information.ldlt().solve(-(prior * off + share * normal.gradient));
    belief.pose = {belief.pose.x_m + move.x(), belief.pose.y_m + move.y(),
                   geometry::wrap_angle(belief.pose.heading_rad + move.z())};
    if (move.head<2>().norm() < 1e-4 && std::abs(move.z()) < 1e-4) break;
  }
  belief.covariance = information.inverse();
  return belief;
}

}  // namespace tocsin::localisation
