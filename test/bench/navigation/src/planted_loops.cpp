// SPDX-License-Identifier: Apache-2.0
#include "planted_loops.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace tocsin::bench {
namespace {

using geometry::compose;
using geometry::Pose;

constexpr double town_m = 25;  // half its side

Eigen::Matrix3d sure(double sigma_m, double sigma_rad) {
  const double place = 1 / (sigma_m * sigma_m);
  return Eigen::Vector3d(place, place, 1 / (sigma_rad * sigma_rad)).asDiagonal();
}

Pose noisy(const Pose& pose, double sigma_m, double sigma_rad, std::mt19937& random) {
  std::normal_distribution<double> normal;
  return {pose.x_m + sigma_m * normal(random), pose.y_m + sigma_m * normal(random),
          pose.heading_rad + sigma_rad * normal(random)};
}

std::vector<Pose> streets(std::size_t nodes) {
  std::mt19937 random(3);
  std::vector<Pose> poses;
  Pose pose;
  for (std::size_t i = 0; i < nodes; ++i) {
    poses.push_back(pose);
    double turn_rad = 0;
    if (i % 5 == 4) turn_rad = random() % 2 == 0 ? pi / 2 : -pi / 2;
    const Pose ahead = compose(pose, compose({1, 0, turn_rad}, {5, 0, 0}));
    const bool leaves = std::max(std::abs(ahead.x_m), std::abs(ahead.y_m)) > town_m;
    if (turn_rad != 0 && leaves) turn_rad = -turn_rad;
    pose = compose(pose, {1, 0, turn_rad});
  }
  return poses;
}

}  // namespace

TownGraph town_graph(std::size_t nodes, int false_loops) {
  TownGraph town;
  town.truth = streets(nodes);
  std::mt19937 random(11);
  for (std::size_t i = 0; i < nodes; ++i) {
    if (i == 0) {
      town.graph.add_node(town.truth[0]);
      continue;
    }
    const Pose step = noisy(relative(town.truth[i - 1], town.truth[i]), 0.02, 0.005, random);
    town.graph.add_node(compose(town.graph.poses().back(), step));
    town.graph.add({i - 1, i, step, sure(0.02, 0.005), false});
  }
  for (std::size_t i = 0; i < nodes; ++i) {
    for (std::size_t j = i + 10; j < nodes; ++j) {
      if (geometry::distance(position(town.truth[i]), position(town.truth[j])) > 0.5) continue;
      const Pose loop = noisy(relative(town.truth[i], town.truth[j]), 0.02, 0.01, random);
      town.graph.add({i, j, loop, sure(0.02, 0.01), true});
    }
  }
  std::mt19937 other(5);
  for (int i = 0; i < false_loops; ++i) {
    const std::size_t from = other() % nodes;
    const std::size_t to = (from + 50 + other() % (nodes / 2)) % nodes;
    if (from == to) continue;
    town.graph.add({from, to, noisy({}, 0.3, 0.3, other), sure(0.02, 0.01), true});
  }
  return town;
}

double error_m(const TownGraph& town) {
  double sum = 0;
  for (std::size_t i = 0; i < town.truth.size(); ++i) {
    sum += geometry::distance(position(town.graph.poses()[i]), position(town.truth[i]));
  }
  return sum / static_cast<double>(town.truth.size());
}

}  // namespace tocsin::bench
