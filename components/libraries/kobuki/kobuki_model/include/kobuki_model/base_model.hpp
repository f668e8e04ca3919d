// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <string>

#include "foundation/time.hpp"
#include "geometry/pose.hpp"
#include "geometry/twist.hpp"
#include "kobuki_model/body.hpp"
#include "kobuki_model/dock.hpp"
#include "kobuki_model/drive.hpp"
#include "kobuki_model/model_params.hpp"
#include "kobuki_model/power.hpp"
#include "kobuki_protocol/command.hpp"
#include "kobuki_protocol/reassembler.hpp"

namespace tocsin::kobuki {

/// What a hand or the room does to the base.
struct BaseInputs {
  std::uint8_t buttons = 0;
  std::uint8_t bumper = 0;  ///< in addition to what the walls press
  std::uint8_t cliff = 0;
  std::uint8_t wheel_drop = 0;
  std::uint8_t over_current = 0;
  std::uint16_t digital = 0;
  std::array<std::uint16_t, 4> analog{4060, 4060, 4060, 4060};  ///< open, as in real captures
  DockInfrared dock;  ///< in addition to what a dock in the room shines
  double slip = 0;    ///< share of the wheels' turning that does not move the base [range 0,1]
};

/// What the computer has set or asked for.
struct BaseOutputs {
  BaseControl control;  ///< the last velocity
  OutputRegister outputs;
  std::optional<Tune> last_tune;
  std::optional<Tone> last_tone;
  std::uint64_t sounds = 0;
  ControllerGains gains;
};

/// What survives when the simulator restarts but the base, seen from outside, did not.
struct BaseMemory {
  geometry::Pose pose;
  double left_ticks = 0;
  double right_ticks = 0;
  double gyro_rad = 0;
  double clock_s = 0;  ///< since power-on
  double charge = 1;
};

/// A Kobuki base, stepped in time: takes command bytes, gives a feedback frame every 20 ms.
///
/// Pure and seeded: the same calls give the same bytes. Usable behind a pseudo-terminal and in
/// simulated time. Physics runs in steps of at most a frame, of 5 ms near an obstacle.
/// `now` must not decrease.
class BaseModel {
 public:
  using FrameSink = std::function<void(Time sent, ByteView frame)>;

  /// Powered on at `now` at `start`. Throws ConfigError when a version text is not like "1.2.0".
  BaseModel(const ModelParams& params, Surroundings surroundings, const geometry::Pose& start,
            std::uint64_t seed, Time now);

  /// Takes what the computer sent until `now`, cut anywhere.
  void receive(ByteView bytes, Time now);
  /// Moves the world to `now` and hands over each frame that became due, oldest first.
  void step(Time now, const FrameSink& sink);
  /// When the next frame is due.
  [[nodiscard]] Time next_frame() const { return next_frame_; }
  /// Cuts the power for a moment: encoders start anywhere, clock and gyro at 0, outputs at default.
  void power_cycle(Time now);

  /// Stands a dock into the room; its front must also be in the surroundings to stop the base.
  void set_dock(const Dock& dock) { dock_ = dock; }

  /// What it answers to version requests from now on. False, and nothing changed, when a text is no
  /// version like "1.2.0".
  [[nodiscard]] bool set_versions(const std::string& hardware, const std::string& firmware,
                                  bool old_form);
  [[nodiscard]] const Version& hardware() const { return hardware_; }
  [[nodiscard]] const Version& firmware() const { return firmware_; }
  void set_gains(const ControllerGains& gains) { outputs_.gains = gains; }

  [[nodiscard]] BaseInputs& inputs() { return inputs_; }
  [[nodiscard]] Power& power() { return power_; }
  [[nodiscard]] const BaseOutputs& outputs() const { return outputs_; }
  /// The true pose in the map frame.
  [[nodiscard]] const geometry::Pose& pose() const { return body_.pose(); }
  void place(const geometry::Pose& pose) { body_.place(pose); }
  /// Something in the surroundings is elsewhere now: to be called before each step while people
  /// walk.
  void surroundings_moved() { body_.surroundings_moved(); }
  /// True velocity at the end of the last physics step.
  [[nodiscard]] const geometry::Twist& velocity() const { return velocity_; }
  [[nodiscard]] std::uint8_t bumper() const;
  [[nodiscard]] const DecodeCounts& command_counts() const { return command_counts_; }
  [[nodiscard]] const Reassembler::Counts& frame_counts() const { return reassembler_.counts(); }

  [[nodiscard]] BaseMemory memory(Time now) const;
  void recall(const BaseMemory& memory, Time now);

 private:
  struct Answers {
    bool hardware = false;
    bool firmware = false;
    bool unique_id = false;
    bool gains = false;
  };
  void obey(const Command& command, Time now);
  void request(const RequestExtra& request);
  /// From `last_` to `now`.
  void physics(Time now);
  [[nodiscard]] geometry::Twist true_velocity(const WheelSpeeds& rolling) const;
  /// What is drawn once a frame.
  void draw_slip();
  void drift_gyro();
  void touch_dock();
  [[nodiscard]] double noise(double sigma);
  [[nodiscard]] double motor_current_a(double speed_mps, double target_mps) const;

  [[nodiscard]] Feedback sense(Time now);
  [[nodiscard]] CoreSensors core_sensors(Time now) const;
  void disturb_encoders(CoreSensors& core);
  [[nodiscard]] Inertia inertia();
  [[nodiscard]] RawGyro raw_gyro();
  [[nodiscard]] DockInfrared dock_infrared();
  void miss_signals(DockInfrared& seen);
  [[nodiscard]] GeneralInput general_input() const;
  [[nodiscard]] CliffAdc cliff_adc() const;
  void answer(Feedback& feedback);

  ModelParams params_;
  Version hardware_;
  Version firmware_;
  UniqueId unique_id_{};
  std::mt19937_64 random_;
  Drive drive_;
  Body body_;
  Power power_;
  Reassembler reassembler_;
  DecodeCounts command_counts_;
  std::optional<Dock> dock_;
  bool docked_ = false;
  BaseInputs inputs_;
  BaseOutputs outputs_;
  Answers asked_;
  geometry::Twist velocity_;
  double left_ticks_ = 0;
  double right_ticks_ = 0;
  double left_slip_ = 0;
  double right_slip_ = 0;
  double gyro_rad_ = 0;
  std::uint8_t gyro_frame_id_ = 0;
  Time powered_on_;
  Time last_;
  Time next_frame_;
};

}  // namespace tocsin::kobuki
