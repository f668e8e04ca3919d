// SPDX-License-Identifier: Apache-2.0
#include "collision_brake/collision_brake.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "foundation/numbers.hpp"

namespace tocsin {
namespace {

using Action = CollisionBrake::Action;
using geometry::Point;

constexpr double body_m = 0.18;
constexpr double margin_m = 0.04;

/// A vehicle at the origin of odometry that looks ahead along x.
class CollisionBrakeTest : public ::testing::Test {
 protected:
  /// A turn that meets these points, and walls 2.9 m away all around.
  static laser::Scan seen(const std::vector<Point>& points, double wall_m = 2.9) {
    laser::Scan scan;
    for (int i = 0; i < 360; ++i) {
      scan.hits.push_back({wall_m * std::cos(i * degree), wall_m * std::sin(i * degree)});
    }
    scan.hits.insert(scan.hits.end(), points.begin(), points.end());
    scan.ranges_m.assign(360, static_cast<float>(wall_m));
    return scan;
  }
  void look(const std::vector<Point>& points) {
    now_ += seconds(0.1);
    sut_.on_pose({}, velocity_, now_);
    sut_.on_scan(seen(points), {}, now_);
  }
  /// What stands where it stood.
  void stands(const std::vector<Point>& points) {
    look(points);
    look(points);
  }
  [[nodiscard]] double allowed(double v, double w = 0) const {
    return sut_.check({v, w}, now_).velocity.linear_mps;
  }
  /// The way from a speed to standing by the documented formula [m].
  static double stopping_m(double v) { return v * 0.25 + v * v / 2; }

  CollisionBrake sut_{{}};
  geometry::Twist velocity_;
  Time now_ = Time{} + seconds(100);
};

TEST_F(CollisionBrakeTest, StandsBeforeWhatIsAheadOnAStraightWay) {
  for (const double free_m : {1.0, 0.5, 0.2, 0.05}) {
    stands({{body_m + margin_m + free_m, 0}});
    EXPECT_NEAR(stopping_m(allowed(3)), free_m, 1e-9) << free_m;
    EXPECT_EQ(sut_.check({3, 0}, now_).action, Action::approach);
    EXPECT_EQ(sut_.check({0.03, 0}, now_).action, Action::none);
  }
  stands({{body_m + margin_m, 0}});
  EXPECT_EQ(allowed(0.7), 0);
  EXPECT_EQ(sut_.check({0.7, 0.3}, now_).action, Action::stop);
  EXPECT_EQ(sut_.check({0.7, 0.3}, now_).velocity.angular_rad_s, 0.3) << "it may turn away";
}

TEST_F(CollisionBrakeTest, WhatIsBesideTheWayDoesNotCount) {
  stands({{0.5, body_m + margin_m + 0.01}, {0.5, -body_m - margin_m - 0.01}});
  EXPECT_EQ(allowed(1), 1) << "a gap of 0.46 m";
  stands({{0.5, body_m + margin_m - 0.01}});
  EXPECT_LT(allowed(1), 1);
}

TEST_F(CollisionBrakeTest, LooksAlongTheArcToBothSides) {
  for (const double side : {1.0, -1.0}) {
    stands({{1, side}});  // on the circle of 1 m radius
    EXPECT_EQ(allowed(2), 2);
    EXPECT_LT(allowed(2, side * 2), 2);
    EXPECT_EQ(allowed(2, -side * 2), 2);
    stands({{-1, side}});  // and backwards
    EXPECT_GT(allowed(-2, -side * 2), -2);
    EXPECT_EQ(allowed(-2, side * 2), -2);
    const auto verdict = sut_.check({-2, -side * 2}, now_);
    EXPECT_NEAR(verdict.velocity.angular_rad_s, side * verdict.velocity.linear_mps, 1e-9)
        << "the arc stays";
  }
}

TEST_F(CollisionBrakeTest, OnTheArcItStandsWhereTheFormulaSays) {
  // Touches a point at 90 degrees of the circle of 1 m where the chord is the reach.
  look({{1, 1}});
  const double reach_m = body_m + margin_m;
  const double free_m = pi / 2 - 2 * std::asin(reach_m / 2);
  const double speed_mps = allowed(3, 3);
  EXPECT_NEAR(stopping_m(speed_mps), free_m, 1e-9);
}

TEST_F(CollisionBrakeTest, ChecksTheArcThatItIsOnToo) {
  velocity_ = {0.5, 0};
  stands({{0.4, 0}});
  EXPECT_LT(allowed(0.5, 5), 0.5) << "wheels turn it later than it is told";
  velocity_ = {-0.5, 0};
  stands({{0.4, 0}});
  EXPECT_EQ(allowed(0.5, 5), 0.5);
}

TEST_F(CollisionBrakeTest, WhatLeansOnItMayBeLeftAndPassedButNotPushed) {
  look({{body_m + 0.005, 0}});
  EXPECT_EQ(allowed(0.3), 0);
  EXPECT_EQ(allowed(-0.3), -0.3);
  EXPECT_EQ(sut_.check({0, 1}, now_).velocity.angular_rad_s, 1);
  look({{0.02, body_m + 0.02}});
  EXPECT_EQ(allowed(0.3), 0.3) << "within the margin, beside it";
  look({{0.1, body_m + 0.005}});
  EXPECT_LT(allowed(0.3, 0.5), 0.3) << "turning into it";
}

TEST_F(CollisionBrakeTest, KnowsWhereTheScanWasMadeWhenTheVehicleHasMovedSince) {
  look({{1.5, 0}});
  now_ += seconds(0.1);
  sut_.on_pose({1, 0, 0}, {}, now_);
  EXPECT_NEAR(stopping_m(allowed(0.7)), 0.5 - body_m - margin_m, 1e-9);
  sut_.on_pose({1, 0, pi / 2}, {}, now_);
  EXPECT_EQ(allowed(0.7), 0.7) << "it has turned away";
}

TEST_F(CollisionBrakeTest, IsSlowerForWhatComesNearerByItself) {
  look({{1.2, 0}});
  look({{1.2, 0}});
  const double standing_mps = allowed(0.7);
  look({{1.3, 0}});
  look({{1.2, 0}});  // 1 m/s
  const double free_m = 1.2 - body_m - margin_m;
  const double v = allowed(0.7);
  EXPECT_LT(v, standing_mps);
  EXPECT_NEAR(v * 0.25 + v * v / 2 + 1 * (0.25 + v), free_m, 1e-9);
  look({{1.2, 0}});
  look({{0.6, 0}});  // 6 m/s: another thing
  EXPECT_NEAR(stopping_m(allowed(0.7)), 0.6 - body_m - margin_m, 1e-9);
}

TEST_F(CollisionBrakeTest, StopsForWhoWalksTowardsItsWay) {
  const auto person = [](double y_m) {
    std::vector<Point> points;
    for (int i = -3; i <= 3; ++i) points.push_back({1 + 0.03 * i, y_m});
    return points;
  };
  stands(person(0.9));
  EXPECT_EQ(allowed(0.5), 0.5) << "stands beside the way";
  look(person(0.75));
  const double gap_m = 0.75 - body_m - margin_m;
  EXPECT_NEAR(allowed(0.5), gap_m / 0.8 - 0.25, 0.02);
  look(person(0.45));
  EXPECT_NEAR(allowed(0.5), 0.45 / 0.8 - 0.22 / 0.8 - 0.25, 0.02);
  for (int i = 0; i < 8; ++i) look(person(0.45));
  EXPECT_EQ(allowed(0.5), 0.5) << "has stopped";
}

TEST_F(CollisionBrakeTest, StandsWithoutAScanOrOdometryThatIsFresh) {
  EXPECT_STREQ(sut_.check({0.3, 0}, now_).reason, "no_scan");
  look({});
  EXPECT_EQ(allowed(0.3), 0.3);
  now_ += seconds(0.59);
  sut_.on_pose({}, {}, now_);
  EXPECT_EQ(allowed(0.3), 0.3);
  now_ += seconds(0.02);
  EXPECT_STREQ(sut_.check({0.3, 0.4}, now_).reason, "no_scan");
  EXPECT_EQ(sut_.check({0.3, 0.4}, now_).velocity.angular_rad_s, 0.4);
  sut_.on_scan(seen({}), {}, now_);
  EXPECT_EQ(allowed(0.3), 0.3);
  now_ += seconds(0.3);
  sut_.on_scan(seen({}), {}, now_);
  now_ += seconds(0.31);
  EXPECT_STREQ(sut_.check({0.3, 0}, now_).reason, "no_odometry");
}

TEST_F(CollisionBrakeTest, CrawlsOrPassesWithoutAScanWhenToldTo) {
  CollisionBrake::Params params;
  params.without_scan = WithoutScan::crawl;
  const auto crawling = CollisionBrake(params).check({0.4, 0.2}, now_);
  EXPECT_NEAR(crawling.velocity.linear_mps, 0.1, 1e-12);
  EXPECT_NEAR(crawling.velocity.angular_rad_s, 0.05, 1e-12);
  EXPECT_EQ(crawling.action, Action::limit);
  EXPECT_EQ(CollisionBrake(params).check({-0.05, 0}, now_).action, Action::none);
  params.without_scan = WithoutScan::pass;
  EXPECT_EQ(CollisionBrake(params).check({0.4, 0.2}, now_).velocity.linear_mps, 0.4);
}

TEST_F(CollisionBrakeTest, AScanThatDoesNotChangeWhileItDrivesIsNone) {
  velocity_ = {0.3, 0};
  for (int i = 0; i < 11; ++i) look({});
  EXPECT_EQ(allowed(0.3), 0.3) << "for a second";
  look({});
  look({});
  EXPECT_STREQ(sut_.check({0.3, 0}, now_).reason, "stuck_scan");
  sut_.on_scan(seen({}, 2.8), {}, now_);
  EXPECT_EQ(allowed(0.3), 0.3);
  velocity_ = {};
  for (int i = 0; i < 30; ++i) look({{2.5, 0}});
  EXPECT_EQ(allowed(0.3), 0.3) << "it stood";
}

TEST_F(CollisionBrakeTest, DoesNotDriveToWhereNothingIsSeen) {
  const auto look_within = [this](double half_deg, bool returns) {
    now_ += seconds(0.1);
    laser::Scan scan;
    for (int i = -179; i <= 180; ++i) {
      const Point end{2.9 * std::cos(i * degree), 2.9 * std::sin(i * degree)};
      if (std::abs(i) <= half_deg) scan.hits.push_back(end);
      if (std::abs(i) > half_deg && returns) scan.misses.push_back(end);
    }
    sut_.on_pose({}, {}, now_);
    sut_.on_scan(scan, {}, now_);
  };
  look_within(28.5, false);  // a Kinect
  EXPECT_EQ(allowed(0.3), 0.3);
  EXPECT_STREQ(sut_.check({-0.1, 0}, now_).reason, "blind");
  sut_.on_pose({0, 0, 1}, {}, now_);
  EXPECT_STREQ(sut_.check({0.3, 0}, now_).reason, "blind") << "turned away from what was seen";
  look_within(140, true);
  EXPECT_EQ(allowed(-0.1), -0.1) << "open floor behind";
  look_within(180, true);
  look_within(140, true);
  EXPECT_STREQ(sut_.check({-0.1, 0}, now_).reason, "blind") << "80 degrees were lost at once";
  look_within(140, true);
  EXPECT_STREQ(sut_.check({-0.1, 0}, now_).reason, "blind") << "and are still";
  look_within(180, true);
  EXPECT_EQ(allowed(-0.1), -0.1);
  for (const double half_deg : {170, 160, 150, 140}) look_within(half_deg, true);
  EXPECT_EQ(allowed(-0.1), -0.1) << "open floor, piece by piece";
}

TEST_F(CollisionBrakeTest, IsOffForItsTimeWhenAPersonAsks) {
  stands({{0.18, 0}});
  sut_.on_bypass(true, now_);
  EXPECT_EQ(allowed(0.3), 0.3);
  EXPECT_STREQ(sut_.check({0.3, 0}, now_).reason, "bypass");
  sut_.on_bypass(false, now_);
  EXPECT_EQ(allowed(0.3), 0);
  sut_.on_bypass(true, now_);
  now_ += seconds(10);
  EXPECT_NE(allowed(0.3), 0.3);
}

TEST_F(CollisionBrakeTest, NumbersThatAreNoneStopItOrAreIgnored) {
  look({});
  EXPECT_EQ(sut_.check({nan, 0}, now_).action, Action::stop);
  EXPECT_EQ(sut_.check({0.3, infinity}, now_).velocity.linear_mps, 0);
  sut_.on_pose({nan, 0, 0}, {}, now_);
  sut_.on_scan(seen({{0.3, 0}}), {nan, 0, 0}, now_);
  EXPECT_EQ(allowed(0.3), 0.3);
}

}  // namespace
}  // namespace tocsin
