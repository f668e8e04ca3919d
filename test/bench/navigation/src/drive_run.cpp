// SPDX-License-Identifier: Apache-2.0
#include "drive_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <utility>
#include <vector>

#include "collision_brake/collision_brake.hpp"
#include "foundation/numbers.hpp"
#include "kobuki_model/base_model.hpp"
#include "kobuki_protocol/velocity.hpp"
#include "laser_geometry/scan.hpp"
#include "laser_model/laser_model.hpp"

namespace tocsin::bench {
namespace {

using std::chrono::milliseconds;

constexpr std::size_t beams = 360;
constexpr double body_m = 0.176;  // nearer is touched
constexpr double tolerance_m = 0.3;
constexpr auto step = milliseconds(20);  // of the base
constexpr auto turn = milliseconds(60);  // between velocities
const Time start_time = Time{} + std::chrono::hours(1);

double median(std::vector<double>& values) {
  if (values.empty()) return nan;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <class Work>
double microseconds_of(Work work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin)
      .count();
}

class Drive {
 public:
  Drive(DriveTask task, const Navigator::Params& params)
      : task_(std::move(task)),
        navigator_(params, task_.map),
        base_(
            {},
            [this](double x_m, double y_m, double radius_m) {
              return task_.scene.touched(x_m, y_m, radius_m);
            },
            task_.start, task_.seed, start_time),
        laser_(laser::find_laser_profile("rplidar_a1"), task_.seed),
        scan_period_(seconds(1 / laser_.profile().turn_hz)) {
    Goal goal;
    goal.id = 1;
    goal.pose = {task_.goal.x_m, task_.goal.y_m, 0};
    goal.tolerance_m = tolerance_m;
    goal.expires = start_time + seconds(2 * task_.most_s);
    (void)navigator_.on_local_goal(std::move(goal), start_time);
  }

  DriveResult run() {
    const Time end = start_time + seconds(task_.most_s);
    while (now_ < end && !is_over()) advance();
    result_.time_s = to_seconds(now_ - start_time);
    result_.scan_us = median(scans_us_);
    result_.update_us = median(updates_us_);
    result_.brake_us = median(brakes_us_) + median(checks_us_);
    result_.last = base_.pose();
    return result_;
  }

 private:
  void advance() {
    now_ += step;
    task_.people.walk(to_seconds(step), position(base_.pose()), body_m, task_.scene);
    base_.surroundings_moved();
    const geometry::Point before = position(base_.pose());
    base_.step(now_, [](Time, ByteView) {});
    result_.way_m += distance(before, position(base_.pose()));
    poses_.push_back(base_.pose());
    navigator_.on_pose(base_.pose(), now_);
    brake_.on_pose(base_.pose(), base_.velocity(), now_);
    if (now_ >= next_scan_) scan();
    if (now_ >= next_turn_) command();
  }

  /// The turn that has just ended; its first beam is as old as it took.
  void scan() {
    next_scan_ = now_ + scan_period_;
    const double period_s = to_seconds(scan_period_);
    const auto pose_at = [&](double s) {
      const double ago = (period_s - s) / to_seconds(step);
      const auto back = std::min(poses_.size() - 1, static_cast<std::size_t>(std::max(0.0, ago)));
      return poses_[poses_.size() - 1 - back];
    };
    const double interval_s = period_s / beams;
    const auto ranges_m = laser_.turn(task_.scene, beams, interval_s, pose_at);
    const laser::Beams lie{{}, -pi, 2 * pi / beams, interval_s, base_.velocity()};
    laser::ScanParams params;
    params.min_range_m = laser_.profile().min_range_m;
    params.max_range_m = laser_.profile().max_range_m;
    const laser::Scan scan = laser::make_scan(ranges_m, lie, params);
    scans_us_.push_back(microseconds_of([&] { navigator_.on_scan(scan, pose_at(0), now_); }));
    brakes_us_.push_back(microseconds_of([&] { brake_.on_scan(scan, pose_at(0), now_); }));
    obey();
    while (poses_.size() > 50) poses_.pop_front();
  }

  void command() {
    next_turn_ = now_ + turn;
    Navigator::Output output;
    updates_us_.push_back(microseconds_of([&] { output = navigator_.update(now_); }));
    result_.plan_us = std::max(result_.plan_us, updates_us_.back());
    if (*output.status.reason != 0) result_.reason = output.status.reason;
    wish_ = output.velocity;
    obey();
  }

  void obey() {
    geometry::Twist velocity;
    checks_us_.push_back(microseconds_of([&] { velocity = brake_.check(wish_, now_).velocity; }));
    base_.receive(kobuki::encode_command(kobuki::encode_velocity(velocity)).bytes(), now_);
  }

  bool is_over() {
    const geometry::Pose& pose = base_.pose();
    if (!task_.scene.touched(pose.x_m, pose.y_m, body_m).empty()) {
      const bool stands = std::abs(base_.velocity().linear_mps) < 0.02;
      result_.end = stands ? DriveEnd::struck : DriveEnd::collided;
      return true;
    }
    if (distance(position(pose), task_.goal) > tolerance_m) return false;
    result_.end = DriveEnd::arrived;
    return true;
  }

  DriveTask task_;
  Navigator navigator_;
  kobuki::BaseModel base_;
  laser::LaserModel laser_;
  Duration scan_period_;
  Time now_ = start_time;
  Time next_scan_ = start_time;
  Time next_turn_ = start_time;
  std::deque<geometry::Pose> poses_;
  std::vector<double> scans_us_;
  std::vector<double> updates_us_;
  std::vector<double> brakes_us_;
  std::vector<double> checks_us_;
  CollisionBrake brake_{{}};
  geometry::Twist wish_;
  DriveResult result_;
};

}  // namespace

DriveResult drive(DriveTask task, const Navigator::Params& params) {
  return Drive(std::move(task), params).run();
}

}  // namespace tocsin::bench
