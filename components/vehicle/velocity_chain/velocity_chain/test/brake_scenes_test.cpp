// SPDX-License-Identifier: Apache-2.0
/// Random scenes and random wishes through brake, smoother and the model of the base: what stands
/// and can be seen is never touched. TOCSIN_BRAKE_SCENES sets how many; it prints what it did.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <random>

#include "collision_brake/collision_brake.hpp"
#include "foundation/numbers.hpp"
#include "kobuki_model/base_model.hpp"
#include "kobuki_protocol/velocity.hpp"
#include "laser_model/laser_model.hpp"
#include "velocity_smoother/velocity_smoother.hpp"

namespace tocsin {
namespace {

using std::chrono::milliseconds;

constexpr double body_m = 0.176;
constexpr std::size_t beams = 360;

VelocitySmoother::Params smoother_params() {
  VelocitySmoother::Params params;  // of config/mission.yaml
  params.accel_lim_v_mps2 = 1.0;
  params.accel_lim_w_rad_s2 = 6.0;
  params.decel_factor = 2.0;
  return params;
}

/// A vehicle that is driven blindly about, with an RPLIDAR A1.
class BlindDrive {
 public:
  BlindDrive(laser::Scene scene, std::uint64_t seed)
      : scene_(std::move(scene)),
        random_(seed),
        laser_(laser::find_laser_profile("rplidar_a1"), seed),
        scan_period_(seconds(1 / laser_.profile().turn_hz)),
        model_(
            {},
            [this](double x_m, double y_m, double radius_m) {
              return scene_.touched(x_m, y_m, radius_m);
            },
            {}, seed, now_) {}

  /// True when it has touched something.
  bool drive(double s) {
    for (const Time end = now_ + seconds(s); now_ < end;) {
      step();
      const geometry::Pose& pose = model_.pose();
      if (!scene_.touched(pose.x_m, pose.y_m, body_m).empty()) return true;
    }
    return false;
  }
  [[nodiscard]] double way_m() const { return way_m_; }
  [[nodiscard]] const geometry::Pose& pose() const { return model_.pose(); }
  [[nodiscard]] geometry::Twist wish() const { return wish_; }

 private:
  void step() {
    now_ += milliseconds(10);
    const geometry::Point before = position(model_.pose());
    model_.step(now_, [](Time, ByteView) {});
    way_m_ += distance(before, position(model_.pose()));
    poses_.push_back(model_.pose());
    if (poses_.size() > 100) poses_.pop_front();
    if (++steps_ % 2 == 0) brake_.on_pose(model_.pose(), model_.velocity(), now_);
    if (now_ >= next_scan_) scan();
    if (steps_ % 5 == 0) command();
    if (const auto velocity = smoother_.update(now_)) wanted_ = *velocity;
    if (steps_ % 2 == 0) {
      model_.receive(kobuki::encode_command(kobuki::encode_velocity(wanted_)).bytes(), now_);
    }
  }

  /// A turn that has just ended; its first beam is as old as it took.
  void scan() {
    next_scan_ = now_ + scan_period_;
    const double period_s = to_seconds(scan_period_);
    const auto pose_at = [&](double s) {
      const auto back = static_cast<std::size_t>(std::max(0.0, (period_s - s) / 0.01));
      return poses_[poses_.size() - 1 - std::min(back, poses_.size() - 1)];
    };
    const auto ranges_m = laser_.turn(scene_, beams, period_s / beams, pose_at);
    laser::ScanParams params;
    params.min_range_m = laser_.profile().min_range_m;
    params.max_range_m = laser_.profile().max_range_m;
    brake_.on_scan(
        laser::make_scan(ranges_m, {{}, -pi, 2 * pi / beams, period_s / beams, model_.velocity()},
                         params),
        pose_at(0), now_);
  }

  void command() {
    if (now_ >= next_wish_) {
      std::uniform_real_distribution<> speed(-0.7, 0.7);
      std::uniform_real_distribution<> turn(-2, 2);
      std::uniform_real_distribution<> lasts(0.3, 4);
      wish_ = {speed(random_), random_() % 3 == 0 ? 0 : turn(random_)};
      next_wish_ = now_ + seconds(lasts(random_));
    }
    smoother_.on_command(brake_.check(wish_, now_).velocity, now_);
  }

  Time now_ = Time{} + seconds(100);
  laser::Scene scene_;
  std::mt19937_64 random_;
  laser::LaserModel laser_;
  Duration scan_period_;
  kobuki::BaseModel model_;
  CollisionBrake brake_{{}};
  VelocitySmoother smoother_{smoother_params()};
  std::deque<geometry::Pose> poses_;
  geometry::Twist wish_;
  geometry::Twist wanted_;
  Time next_scan_ = now_;
  Time next_wish_ = now_;
  int steps_ = 0;
  double way_m_ = 0;
};

/// A room with boxes and pillars, none nearer than 0.4 m to the middle.
laser::Scene random_scene(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  const double x_m = uniform(0.8, 4);
  const double y_m = uniform(0.8, 4);
  std::vector<geometry::Wall> walls{{-x_m, -y_m, x_m, -y_m, 1},
                                    {x_m, -y_m, x_m, y_m, 1},
                                    {x_m, y_m, -x_m, y_m, 1},
                                    {-x_m, y_m, -x_m, -y_m, 1}};
  laser::Obstacles obstacles;
  for (int i = 0; i < 8; ++i) {
    const geometry::Point at{uniform(-x_m, x_m), uniform(-y_m, y_m)};
    const double size_m = uniform(0.05, 0.5);
    if (std::hypot(at.x_m, at.y_m) < 0.4 + size_m) continue;
    if (i % 2 == 0) {
      obstacles.discs.push_back({at, size_m / 2});
    } else {
      obstacles.boxes.push_back({{at.x_m, at.y_m, uniform(0, pi)}, size_m, size_m / 2});
    }
  }
  return laser::Scene(walls, obstacles);
}

TEST(BrakeScenes, WhatStandsIsNeverTouchedWhateverIsWished) {
  const char* const asked = std::getenv("TOCSIN_BRAKE_SCENES");
  const int scenes = asked != nullptr ? std::atoi(asked) : 30;
  double way_m = 0;
  int touched = 0;
  for (int seed = 1; seed <= scenes; ++seed) {
    BlindDrive sut(random_scene(static_cast<std::uint64_t>(seed)),
                   static_cast<std::uint64_t>(seed));
    const bool has_touched = sut.drive(30);
    way_m += sut.way_m();
    touched += has_touched ? 1 : 0;
    EXPECT_FALSE(has_touched) << "scene " << seed << " at (" << sut.pose().x_m << ", "
                              << sut.pose().y_m << ", " << sut.pose().heading_rad << "), wished "
                              << sut.wish().linear_mps << " " << sut.wish().angular_rad_s;
  }
  std::printf("%d scenes, 30 s each, %.0f m: %d touched something\n", scenes, way_m, touched);
  EXPECT_GT(way_m, 2 * scenes) << "it drives";
}

}  // namespace
}  // namespace tocsin
