// SPDX-License-Identifier: Apache-2.0
#include "mapping/pose_graph.hpp"

#include <gtest/gtest.h>

#include <random>

namespace tocsin::mapping {
namespace {

using geometry::Pose;

Eigen::Matrix3d sure(double sigma_m, double sigma_rad) {
  const double place = 1 / (sigma_m * sigma_m);
  return Eigen::Vector3d(place, place, 1 / (sigma_rad * sigma_rad)).asDiagonal();
}

/// A drive over a grid of streets, as the Manhattan world of the literature: 600 nodes 1 m apart
/// with noisy wheels, and a true loop wherever it comes by again.
class Streets {
 public:
  Streets() {
    Pose truth;
    for (int i = 0; i < 600; ++i) {
      truth_.push_back(truth);
      // Streets are 5 m apart; it turns back where the town ends.
      double turn_rad = 0;
      if (i % 5 == 4) turn_rad = random_() % 2 == 0 ? pi / 2 : -pi / 2;
      const Pose next = compose(truth, {6, 0, turn_rad});
      if (turn_rad != 0 && std::max(std::abs(next.x_m), std::abs(next.y_m)) > 12) turn_rad = pi;
      truth = compose(truth, {1, 0, turn_rad});
    }
  }

  /// The graph as a mapper has it before it is solved, with `wrong` false loops planted.
  PoseGraph graph(int wrong, bool doubted) {
    PoseGraph graph;
    random_.seed(11);
    for (std::size_t i = 0; i < truth_.size(); ++i) {
      if (i == 0) {
        graph.add_node(truth_[0]);
        continue;
      }
      const Pose step = noisy(relative(truth_[i - 1], truth_[i]), 0.02, 0.005);
      graph.add_node(compose(graph.poses().back(), step));
      graph.add({i - 1, i, step, sure(0.02, 0.005), false});
    }
    add_true_loops(graph);
    std::uniform_int_distribution<std::size_t> node(0, truth_.size() - 1);
    std::mt19937 other(5);
    for (int i = 0; i < wrong; ++i) {
      const std::size_t from = node(other);
      const std::size_t to = (from + 50 + node(other) % 400) % truth_.size();
      graph.add({from, to, noisy({}, 0.3, 0.3), sure(0.02, 0.01), doubted});
    }
    return graph;
  }

  /// Mean distance from the truth, node 0 at the same place.
  [[nodiscard]] double error_m(const PoseGraph& graph) const {
    double sum = 0;
    for (std::size_t i = 0; i < truth_.size(); ++i) {
      sum += geometry::distance(position(graph.poses()[i]), position(truth_[i]));
    }
    return sum / static_cast<double>(truth_.size());
  }

 private:
  Pose noisy(const Pose& pose, double sigma_m, double sigma_rad) {
    std::normal_distribution<double> normal;
    return {pose.x_m + sigma_m * normal(random_), pose.y_m + sigma_m * normal(random_),
            pose.heading_rad + sigma_rad * normal(random_)};
  }

  void add_true_loops(PoseGraph& graph) {
    for (std::size_t i = 0; i < truth_.size(); ++i) {
      for (std::size_t j = i + 10; j < truth_.size(); ++j) {
        if (geometry::distance(position(truth_[i]), position(truth_[j])) > 0.5) continue;
        graph.add(
            {i, j, noisy(relative(truth_[i], truth_[j]), 0.02, 0.01), sure(0.02, 0.01), true});
      }
    }
  }

  std::mt19937 random_{3};
  std::vector<Pose> truth_;
};

TEST(PoseGraph, SpreadsTheErrorOfAClosedWay) {
  PoseGraph sut;
  for (int i = 0; i < 4; ++i) sut.add_node({1.0 * i, 0, 0});
  for (std::size_t i = 0; i < 3; ++i) sut.add({i, i + 1, {1, 0, 0}, sure(1, 1), false});
  sut.add({3, 0, {-3.4, 0, 0}, sure(1, 1), false});
  sut.solve();
  EXPECT_NEAR(sut.poses()[0].x_m, 0, 1e-9);
  EXPECT_NEAR(sut.poses()[1].x_m, 1.1, 1e-6);
  EXPECT_NEAR(sut.poses()[3].x_m, 3.3, 1e-6);
}

TEST(PoseGraph, HoldsToWhatItIsSureOf) {
  PoseGraph sut;
  sut.add_node({});
  sut.add_node({1, 0, 0});
  sut.add({0, 1, {1, 0, 0}, sure(0.1, 1), false});
  sut.add({0, 1, {2, 0, 0}, sure(0.3, 1), false});
  sut.solve();
  EXPECT_NEAR(sut.poses()[1].x_m, 1.1, 1e-6);
}

TEST(PoseGraph, LeavesWhatNothingTiesToTheFirstNode) {
  PoseGraph sut;
  for (int i = 0; i < 3; ++i) sut.add_node({1.0 * i, 2, 0.5});
  sut.add({0, 1, {2, 0, 0}, sure(0.1, 0.1), false});
  EXPECT_GT(sut.solve(), 0);
  EXPECT_DOUBLE_EQ(sut.poses()[2].x_m, 2);
  EXPECT_DOUBLE_EQ(sut.poses()[0].heading_rad, 0.5);
}

TEST(PoseGraph, OfOneNodeIsSolved) {
  PoseGraph sut;
  sut.add_node({1, 2, 3});
  EXPECT_EQ(sut.solve(), 0);
}

TEST(PoseGraph, TrueLoopsTakeTheDriftAway) {
  Streets streets;
  PoseGraph sut = streets.graph(0, true);
  const double before_m = streets.error_m(sut);
  sut.solve();
  EXPECT_LT(streets.error_m(sut), 0.3 * before_m);
}

TEST(PoseGraph, AHundredFalseLoopsChangeTheResultByLessThanATenth) {
  Streets streets;
  PoseGraph clean = streets.graph(0, true);
  PoseGraph planted = streets.graph(100, true);
  clean.solve();
  planted.solve();
  EXPECT_LT(streets.error_m(planted), 1.1 * streets.error_m(clean));
  double moved_m = 0;
  for (std::size_t i = 0; i < clean.poses().size(); ++i) {
    moved_m += geometry::distance(position(clean.poses()[i]), position(planted.poses()[i]));
  }
  EXPECT_LT(moved_m / 600, 0.1 * streets.error_m(clean));
}

TEST(PoseGraph, FalseLoopsThatMayNotBeDoubtedRuinIt) {
  Streets streets;
  PoseGraph sut = streets.graph(100, false);
  sut.solve();
  EXPECT_GT(streets.error_m(sut), 2);
}

TEST(PoseGraph, HasTheSameResultBitForBit) {
  Streets streets;
  PoseGraph one = streets.graph(20, true);
  PoseGraph two = streets.graph(20, true);
  one.solve();
  two.solve();
  for (std::size_t i = 0; i < one.poses().size(); ++i) {
    EXPECT_EQ(one.poses()[i].x_m, two.poses()[i].x_m);
    EXPECT_EQ(one.poses()[i].heading_rad, two.poses()[i].heading_rad);
  }
}

TEST(PoseGraph, DropsWhatMayBeWrongAndNothingElse) {
  Streets streets;
  PoseGraph sut = streets.graph(20, true);
  sut.drop_doubtful();
  EXPECT_EQ(sut.constraints().size(), 599U);
}

}  // namespace
}  // namespace tocsin::mapping
