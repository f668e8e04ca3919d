// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/pose.hpp"
#include "kobuki_protocol/dimensions.hpp"
#include "kobuki_protocol/feedback.hpp"

namespace tocsin::kobuki {

struct OdometryParams {
  bool use_gyro_heading = true;
  double wheel_separation_m = kobuki::wheel_separation_m;
  double left_wheel_scale = 1.0;
  double right_wheel_scale = 1.0;
  double gyro_scale = 1.0;
  double gyro_bias_rad_s = 0.0;
  double max_wheel_speed_mps = 1.5;
  template <class Visitor>
  void visit(Visitor& v) {
    v("use_gyro_heading", use_gyro_heading, "heading from the gyro, else from the encoders");
    v("wheel_separation_m", wheel_separation_m, {0.15, 0.35},
      "[m] between the wheels; some bases fit 0.246 better");
    v("left_wheel_scale", left_wheel_scale, {0.8, 1.2}, "[1] true over nominal distance, left");
    v("right_wheel_scale", right_wheel_scale, {0.8, 1.2}, "[1] true over nominal distance, right");
    v("gyro_scale", gyro_scale, {0.8, 1.2}, "[1] true over reported turn");
    v("gyro_bias_rad_s", gyro_bias_rad_s, {-0.1, 0.1}, "[rad/s] reported while standing still");
    v("max_wheel_speed_mps", max_wheel_speed_mps, {0.7, 5},
      "[m/s] a faster jump of an encoder is a restarted base, not motion");
  }
};

struct WheelState {
  double angle_rad = 0;
  double rate_rad_s = 0;
};

/// All that a restarted driver needs in order to continue the same odometry.
struct OdometrySnapshot {
  geometry::Pose pose;
  WheelState left;
  WheelState right;
  CoreSensors core;
  std::optional<Inertia> inertia;
  double gyro_heading_rad = 0;
};

/// geometry::Pose from encoder ticks, with the heading of the encoders or of the gyro.
///
/// Pure, one instance per base, no shared state. The first sample only initialises. Encoders and
/// the millisecond stamp are differences modulo 65536. The checksum lets some damaged frames
/// through, so that a sample with a jump that no wheel and no turn can do is left out. When it fits
/// to the last sample but one, the last one was damaged and is undone; when the next one agrees
/// with it and is as impossible, the base was restarted, and motion counts from there. The first
/// sample after a pause of more than 0.1 s waits for the next one in the same way, which brings the
/// motion of the pause.
///
/// After more than 3 s stamp and encoders may have wrapped. Then the sample is motion when its
/// stamp agrees with the computer's clock and its wheels rolled at most 1.2 m, as of a base that
/// stopped by its own timeout; else the base was restarted.
class Odometry {
 public:
  explicit Odometry(const OdometryParams& params);
  /// Takes one frame. `inertia` may be absent: the heading then comes from the encoders.
  /// `elapsed_s`: by the computer's clock, since the last frame after which it did not wait.
  void update(const CoreSensors& core, const std::optional<Inertia>& inertia, double elapsed_s = 0);
  /// Makes the present place the origin.
  void reset();

  [[nodiscard]] const geometry::Pose& pose() const { return pose_; }
  /// Rates of the body; 0 until the second sample.
  [[nodiscard]] double linear_mps() const { return linear_mps_; }
  [[nodiscard]] double angular_rad_s() const { return angular_rad_s_; }
  /// Turned since the first sample or the last reset, by the gyro with scale and bias, whatever the
  /// pose is computed from. Stands while no inertia comes.
  [[nodiscard]] double gyro_heading_rad() const { return gyro_heading_rad_; }
  [[nodiscard]] double gyro_rate_rad_s() const { return gyro_rate_rad_s_; }
  [[nodiscard]] const WheelState& left() const { return left_; }
  [[nodiscard]] const WheelState& right() const { return right_; }
  /// The last sample was left out, or waits for the next one: the pose is that of an older one.
  [[nodiscard]] bool waits() const { return suspect_.has_value(); }
  /// Samples that were left out.
  [[nodiscard]] std::uint64_t rejected_jumps() const { return rejected_jumps_; }

  /// Empty until the first sample.
  [[nodiscard]] std::optional<OdometrySnapshot> snapshot() const;
  void restore(const OdometrySnapshot& snapshot);

 private:
  struct Sample {
    CoreSensors core;
    std::optional<Inertia> inertia;
  };
  struct Suspect {
    Sample sample;
    bool possible;  ///< after the last one
  };
  struct Step {
    double left_m = 0;
    double right_m = 0;
    double dt_s = 0;
    double turn_rad = 0;  ///< by the encoders
    std::optional<double> gyro_turn_rad;
  };
  /// What can be gone back to when the sample after it turns out to be damaged.
  struct State {
    Sample sample;
    geometry::Pose pose;
    double gyro_heading_rad;
    WheelState left;
    WheelState right;
  };
  [[nodiscard]] Step measure(const Sample& from, const Sample& to) const;
  [[nodiscard]] Step measure_over(double silence_s, const Sample& from, const Sample& to) const;
  [[nodiscard]] bool plausible(const Step& step) const;
  [[nodiscard]] bool bridges(const Step& step, double silence_s) const;
  [[nodiscard]] bool agrees_with_suspect(const Sample& now) const;
  /// For a sample that does not fit to the last one: whether it fits to the one before, so that the
  /// last one was damaged and is undone.
  [[nodiscard]] bool undo_if_damaged(const Sample& now);
  void take(const Sample& now, const Step& step);
  void apply(const Step& step);
  void apply_rates(const Step& step, const std::optional<Inertia>& inertia);

  OdometryParams params_;
  geometry::Pose pose_;
  double linear_mps_ = 0;
  double angular_rad_s_ = 0;
  double gyro_heading_rad_ = 0;
  double gyro_rate_rad_s_ = 0;
  WheelState left_;
  WheelState right_;
  std::optional<Sample> last_;
  std::optional<State> before_last_;
  std::optional<Suspect> suspect_;  ///< waits for the next one to agree
  std::uint64_t rejected_jumps_ = 0;
};

}  // namespace tocsin::kobuki
