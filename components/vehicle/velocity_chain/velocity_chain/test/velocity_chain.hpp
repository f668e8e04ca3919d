// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <optional>

#include "collision_brake/collision_brake.hpp"
#include "foundation/numbers.hpp"
#include "geometry/twist.hpp"
#include "kobuki_model/base_model.hpp"
#include "safety_controller/safety_controller.hpp"
#include "velocity_mux/velocity_mux.hpp"
#include "velocity_smoother/velocity_smoother.hpp"

namespace tocsin {

using namespace kobuki;  // NOLINT: every name of the model is used here

/// The way from a source of velocity to the model of the base, part by part as in the vehicle, in
/// virtual time. Each part may die.
class VelocityChain {
 public:
  static constexpr Duration step_time = std::chrono::milliseconds(10);
  static constexpr double driver_timeout_s = 0.6;  // cmd_vel_timeout_s of kobuki_driver

  struct Alive {
    bool source = true;
    bool mux = true;
    bool brake = true;
    bool laser = true;
    bool smoother = true;
    bool safety = true;
    bool driver = true;
  };

  explicit VelocityChain(Surroundings surroundings, const SafetyController::Params& safety = {},
                         const ModelParams& model_params = {})
      : model(model_params, std::move(surroundings), {0, 0, 0}, 3, now), safety_(safety) {}

  /// Runs for a step; `source` gives its velocity every 50 ms.
  void step(const std::function<geometry::Twist()>& source) {
    now += step_time;
    look();
    if (alive.source && now >= next_source_) {
      next_source_ = now + std::chrono::milliseconds(50);
      if (alive.mux) select(mux_.on_command("navigation", source(), now));
    }
    if (alive.mux) select(mux_.on_time(now));
    if (alive.smoother) smooth(smoother_.update(now));
    if (alive.safety) command(safety_.update(now));
    drive();
    model.step(now, [&](Time, ByteView frame) { read(frame); });
  }
  void add_brake() { brake_.emplace(CollisionBrake::Params{}); }
  void press_emergency_stop(bool pressed) {
    mux_.on_emergency_stop(pressed);
    safety_.on_emergency_stop(pressed);
  }

  /// What the driver makes the base do.
  [[nodiscard]] const geometry::Twist& commanded() const { return wanted_; }

  Time now = Time{} + seconds(100);
  Alive alive;
  BaseModel model;
  std::uint8_t bumper = 0;

 private:
  void select(const std::optional<geometry::Twist>& velocity) {
    if (!velocity || !alive.brake || !alive.smoother) return;
    const auto checked = brake_ ? brake_->check(*velocity, now).velocity : *velocity;
    smoother_.on_command(checked, now);
  }
  /// Walls 2.9 m away, wherever it drives.
  void look() {
    if (!brake_) return;
    brake_->on_pose(model.pose(), model.velocity(), now);
    if (!alive.laser || now < next_look_) return;
    next_look_ = now + std::chrono::milliseconds(100);
    laser::Scan scan;
    for (int i = 0; i < 360; ++i) {
      const double range_m = 2.9 + 1e-6 * (++looks_ % 7);
      scan.hits.push_back({range_m * std::cos(i * degree), range_m * std::sin(i * degree)});
    }
    brake_->on_scan(scan, model.pose(), now);
  }
  void smooth(const std::optional<geometry::Twist>& velocity) {
    if (velocity && alive.safety) command(safety_.on_wanted(*velocity, now));
  }
  void command(const std::optional<geometry::Twist>& velocity) {
    if (!velocity) return;
    wanted_ = *velocity;
    wanted_at_ = now;
  }
  void drive() {
    if (!alive.driver || now < next_drive_) return;
    next_drive_ = now + std::chrono::milliseconds(20);
    if (now - wanted_at_ > seconds(driver_timeout_s)) wanted_ = {};
    model.receive(encode_command(encode_velocity(wanted_)).bytes(), now);
  }
  void read(ByteView frame) {
    DecodeCounts counts;
    const Feedback got = decode_feedback(frame.part(3, frame.size - 4), counts);
    bumper = got.core->bumper;
    safety_.on_hazards({got.core->bumper, got.core->cliff, got.core->wheel_drop}, now);
  }

  static VelocitySmoother::Params smoother_params() {
    VelocitySmoother::Params params;  // of config/mission.yaml
    params.accel_lim_v_mps2 = 1.0;
    params.accel_lim_w_rad_s2 = 6.0;
    params.decel_factor = 2.0;
    return params;
  }
  VelocityMux mux_{{{"teleop", 30, 0.5}, {"navigation", 10, 0.5}}};
  VelocitySmoother smoother_{smoother_params()};
  std::optional<CollisionBrake> brake_;
  Time next_look_ = Time::min();
  int looks_ = 0;
  SafetyController safety_;
  geometry::Twist wanted_;
  Time wanted_at_ = Time::min();
  Time next_source_ = Time::min();
  Time next_drive_ = Time::min();
};

}  // namespace tocsin
