// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Docking with the model of the base and the dock's light, in virtual time.

#include <algorithm>
#include <cmath>
#include <random>

#include "auto_docking/auto_docking.hpp"
#include "geometry/pose.hpp"
#include "geometry/twist.hpp"
#include "kobuki_model/base_model.hpp"

namespace tocsin {

/// The dock stands at the origin before a wall, facing +x.
struct DockingRig {
  kobuki::DockLight light;
  kobuki::ModelParams base;
  std::uint64_t seed = 1;

  struct End {
    DockingResult result;
    double duration_s;
    kobuki::ChargingSource source;
    double dark_way_m;  ///< longest way driven without any light in view
  };
  [[nodiscard]] End dock_from(const geometry::Pose& start) const;
};

/// What a base drives while it sees nothing of the dock.
class DarkWay {
 public:
  explicit DarkWay(const geometry::Pose& start) : last_(start) {}
  void update(const geometry::Pose& pose, const DockInfrared& seen) {
    way_m_ += std::hypot(pose.x_m - last_.x_m, pose.y_m - last_.y_m);
    last_ = pose;
    if ((seen.left | seen.centre | seen.right) != 0) way_m_ = 0;
    longest_m_ = std::max(longest_m_, way_m_);
  }
  [[nodiscard]] double longest_m() const { return longest_m_; }

 private:
  geometry::Pose last_;
  double way_m_ = 0;
  double longest_m_ = 0;
};

inline DockingRig::End DockingRig::dock_from(const geometry::Pose& start) const {
  using namespace kobuki;  // NOLINT: every name of the model is used here
  const Time t0 = Time{} + seconds(100);
  const Dock dock({0, 0, 0}, light);
  BaseModel model(base, walled({dock.front(), {-0.05, -5, -0.05, 5, 0}}), start, seed, t0);
  model.set_dock(dock);
  Odometry odometry{OdometryParams{}};
  AutoDocking docking{AutoDocking::Params{}};
  docking.start(t0);
  DarkWay dark(start);
  Time now = t0;
  while (docking.running()) {
    now += std::chrono::milliseconds(20);
    model.step(now, [&](Time at, ByteView frame) {
      DecodeCounts counts;
      const Feedback got = decode_feedback(frame.part(3, frame.size - 4), counts);
      odometry.update(*got.core, got.inertia);
      dark.update(model.pose(), *got.dock_infrared);
      const geometry::Twist wanted = docking.update(
          {*got.dock_infrared, got.core->bumper, got.core->charger, odometry.pose().heading_rad},
          at);
      model.receive(encode_command(encode_velocity(wanted)).bytes(), at);
    });
  }
  return {docking.result(), to_seconds(now - t0), model.power().source(), dark.longest_m()};
}

struct Distances {
  double from_m;
  double to_m;
};
constexpr Distances whole_field{0.4, 2.9};

/// Within 45 degrees of the dock's axis, any heading.
inline geometry::Pose draw_start(std::mt19937_64& random, const Distances& away = whole_field) {
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  const double angle_rad = uniform(-45, 45) * degree;
  const double distance_m = uniform(away.from_m, away.to_m);
  return {distance_m * std::cos(angle_rad), distance_m * std::sin(angle_rad), uniform(-pi, pi)};
}

}  // namespace tocsin
