// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/pose.hpp"
#include "geometry/twist.hpp"
#include "kobuki_driver/inquiry.hpp"
#include "kobuki_driver/velocity_hold.hpp"
#include "kobuki_protocol/battery.hpp"
#include "kobuki_protocol/events.hpp"
#include "kobuki_protocol/odometry.hpp"
#include "kobuki_protocol/reassembler.hpp"

namespace tocsin::kobuki {

/// What one frame with core sensors tells.
struct Reading {
  Feedback feedback;
  Battery battery;
  geometry::Pose pose;
  bool pose_is_old = false;  ///< this frame's encoders wait for the next frame to confirm them
  double linear_mps = 0;
  double angular_rad_s = 0;
  double gyro_heading_rad = 0;  ///< by the gyro, whatever `pose` comes from
  double gyro_rate_rad_s = 0;
  WheelState left;
  WheelState right;
  Events events;
};

/// Whether the base can be driven.
enum class BaseState {
  no_port,  ///< the port is closed
  silent,   ///< the port is open, no frame for `offline_after_s` or none ever
  online,
  refused  ///< its firmware speaks another protocol; it is kept standing and asked again
};

/// The driver without its port: bytes in, readings out, commands out at a fixed rate.
///
/// Nothing is sent before the first good frame, so that a wrong device gets no bytes. From then on
/// a velocity follows each frame (every 20 ms, as kobuki_core does it), 30 ms after the last one
/// when no frame comes, and every 20 ms while the base is silent (then zero).
/// Going silent forgets the velocity: driving resumes only by a new command.
///
/// It is the last component before the wheels and holds the emergency stop itself: while one stands
/// each velocity that it sends is zero, and nothing is sent that changes how the wheels are
/// controlled. Driving resumes only by a new command. Pure, one thread; `now` must not decrease.
class KobukiDriver {
 public:
  struct Params {
    double offline_after_s = 0.16;
    VelocityParams velocity;
    BatteryParams battery;
    OdometryParams odometry;
    template <class Visitor>
    void visit(Visitor& v) {
      v("offline_after_s", offline_after_s, {0.05, 2},
        "[s] silence after which the base is offline");
      velocity.visit(v);
      battery.visit(v);
      odometry.visit(v);
    }
  };
  static constexpr Duration command_period = std::chrono::milliseconds(20);
  using ReadingSink = std::function<void(const Reading& reading)>;
  using ByteSink = std::function<void(ByteView bytes)>;

  /// Throws ConfigError when battery limits are out of order.
  explicit KobukiDriver(const Params& params);

  void on_port_open();
  void on_port_lost();
  /// Takes what was read from the port, cut anywhere, and hands over a reading per frame.
  void on_bytes(ByteView bytes, Time now, const ReadingSink& sink);
  /// How long the cable takes for the rest of the frame under way, at 115200 baud and ten bits a
  /// byte; 0: none is.
  [[nodiscard]] Duration rest_of_frame() const;
  void on_velocity(const geometry::Twist& velocity, Time now);
  /// Off keeps the base standing whatever is commanded; on waits for the next velocity.
  void set_motor_power(bool on);
  [[nodiscard]] bool motor_power() const { return motor_power_; }
  /// True: the base is commanded to stand at once, and as long as it is not called with false.
  void on_emergency_stop(bool stands, Time now);
  [[nodiscard]] bool emergency_stop() const { return velocity_.is_held(); }
  /// LEDs, outputs and supplies; sent now and again after every reconnection.
  void set_outputs(const OutputRegister& outputs);
  [[nodiscard]] const OutputRegister& outputs() const { return outputs_; }
  /// A sound for the next period. Dropped and false when too many wait.
  [[nodiscard]] bool send_once(const Command& command);
  /// Gains of the wheel controllers, asked for again afterwards. Dropped and false unless the
  /// firmware is known to have them (1.2), and while the emergency stop stands: a controller with
  /// other gains may move a wheel that stands.
  [[nodiscard]] bool set_gains(const ControllerGains& gains);
  void reset_odometry() { odometry_.reset(); }
  /// Goes on from the odometry of an earlier driver.
  void resume(const OdometrySnapshot& snapshot, Time odometry_time);
  /// When the frame came that odometry is from; Time::min() before the first.
  [[nodiscard]] Time odometry_time() const { return odometry_time_; }

  /// Sends what is due; call when `next_deadline` has passed, or more often.
  void run(Time now, const ByteSink& sink);
  /// When `run` has something to do; `never` without a port.
  [[nodiscard]] Time next_deadline() const;
  /// The last bytes before the end: zero velocity, three times in case one is damaged.
  void farewell(const ByteSink& sink) const;

  [[nodiscard]] BaseState state() const { return state_; }
  /// What the newest frame told, also while the base is away; null before the first.
  [[nodiscard]] const Reading* last_reading() const {
    return reading_.feedback.core ? &reading_ : nullptr;
  }
  [[nodiscard]] const Inquiry& inquiry() const { return inquiry_; }
  [[nodiscard]] const Reassembler::Counts& frame_counts() const { return reassembler_.counts(); }
  [[nodiscard]] const DecodeCounts& decode_counts() const { return decode_counts_; }
  [[nodiscard]] Odometry& odometry() { return odometry_; }
  [[nodiscard]] const Odometry& odometry() const { return odometry_; }

 private:
  void on_frame(ByteView payload, Time now, const ReadingSink& sink);
  void come_online(Time now);
  void check_firmware(const Feedback& feedback);
  /// Makes the reading of `reading_.feedback`.
  void read(Time now);
  void watch(Time now);
  void send_commands(Time now, const ByteSink& sink);
  [[nodiscard]] BaseControl velocity_command(Time now) const;

  static constexpr std::size_t max_waiting = 16;
  Params params_;
  Duration offline_after_;
  VelocityHold velocity_;
  BatteryReader battery_;
  Odometry odometry_;
  EventDetector events_;
  Inquiry inquiry_;
  Reassembler reassembler_;
  DecodeCounts decode_counts_;
  Reading reading_;
  OutputRegister outputs_;
  std::vector<Command> waiting_;
  BaseState state_ = BaseState::no_port;
  bool motor_power_ = true;
  bool heard_ = false;  ///< since the port was opened
  Time last_frame_ = Time::min();
  Time odometry_time_ = Time::min();
  Time next_command_ = Time::min();
};

}  // namespace tocsin::kobuki
