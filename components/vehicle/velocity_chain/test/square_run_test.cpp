// SPDX-License-Identifier: Apache-2.0
/// A square through the whole chain, steered by odometry.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "geometry/pose.hpp"
#include "velocity_chain.hpp"

namespace tocsin {
namespace {

/// Drives straight legs with a turn of 90 degrees to the left after each.
class Square {
 public:
  Square(VelocityChain& chain, double side_m) : chain_(chain), side_m_(side_m) {}
  [[nodiscard]] bool done() const { return leg_ == 4; }
  geometry::Twist velocity() {
    const geometry::Pose pose = chain_.odometry.pose();
    const double error = geometry::wrap_angle(heading_rad() - pose.heading_rad);
    if (turning_ && std::abs(error) < 0.003) next_leg(pose);
    if (!turning_ && side_m_ - along(pose) < 0.002) turn();
    if (done()) return {};
    if (turning_) return {0, std::clamp(2 * error, -1.0, 1.0)};
    return {std::clamp(1.5 * (side_m_ - along(pose)), 0.02, 0.3), std::clamp(2 * error, -0.3, 0.3)};
  }

 private:
  [[nodiscard]] double heading_rad() const { return (leg_ + (turning_ ? 1 : 0)) * pi / 2; }
  [[nodiscard]] double along(const geometry::Pose& pose) const {
    return (pose.x_m - from_.x_m) * std::cos(heading_rad()) +
           (pose.y_m - from_.y_m) * std::sin(heading_rad());
  }
  void turn() { turning_ = true; }
  void next_leg(const geometry::Pose& pose) {
    turning_ = false;
    from_ = pose;
    ++leg_;
  }
  VelocityChain& chain_;
  double side_m_;
  int leg_ = 0;
  bool turning_ = false;
  geometry::Pose from_;
};

double apart_m(const geometry::Pose& a, const geometry::Pose& b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

TEST(SquareRun, ComesBackToWhereItBegan) {
  VelocityChain chain(open_floor());
  Square square(chain, 1.0);
  const Time begin = chain.now;
  double farthest_m = 0;
  while (!square.done() && chain.now - begin < seconds(120)) {
    chain.step([&] { return square.velocity(); });
    farthest_m = std::max(farthest_m, apart_m(chain.model.pose(), {0, 0, 0}));
  }
  for (int i = 0; i < 100; ++i) chain.step([] { return geometry::Twist{}; });
  const geometry::Pose& truth = chain.model.pose();
  const double off_m = apart_m(truth, {0, 0, 0});
  const double odometry_m = apart_m(truth, chain.odometry.pose());
  std::printf("square of 1 m in %.0f s: %.4f m and %.2f degrees off, odometry %.4f m off\n",
              to_seconds(chain.now - begin), off_m, truth.heading_rad / degree_rad, odometry_m);
  EXPECT_TRUE(square.done());
  EXPECT_NEAR(farthest_m, std::sqrt(2), 0.05);
  EXPECT_LT(off_m, 0.05);
  EXPECT_LT(odometry_m, 0.03);
  EXPECT_NEAR(geometry::wrap_angle(truth.heading_rad), 0, 3 * degree_rad);
}

}  // namespace
}  // namespace tocsin
