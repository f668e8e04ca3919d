// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core.hpp"
#include "deployment/deployment.hpp"
#include "devices/devices.hpp"
#include "devices/serial_device.hpp"
#include "geometry/pose.hpp"
#include "kobuki_model/base_model.hpp"
#include "kobuki_model/serial_line.hpp"
#include "laser_model/room.hpp"
#include "sim_laser.hpp"

namespace tocsin::simulation {

/// What the command line of kobuki_simulator in a bringup file says, as far as a model needs it.
struct BaseOptions {
  std::string link;  ///< path of the serial port
  std::string walls;
  std::string obstacles;
  geometry::Pose start;
  std::optional<geometry::Pose> dock;  ///< middle of its front, facing the room
  std::uint64_t seed = 1;
  kobuki::ModelParams model;
  kobuki::LineParams line;
  LaserOptions laser;
};

/// Throws ConfigError for bad values and files.
[[nodiscard]] BaseOptions read_base_options(const deployment::Program& program);

/// The simulated base behind a serial port in virtual time. The computer gets the bytes of a frame
/// together, when the last of them has arrived: what it does with the first ones is nothing.
class SimBase {
 public:
  SimBase(Core& core, const BaseOptions& options);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const kobuki::BaseModel& model() const { return model_; }
  [[nodiscard]] Time next_event() const;
  /// Null: it has none.
  [[nodiscard]] SimLaser* laser() { return laser_ ? &*laser_ : nullptr; }
  /// Where the vehicle is, for a model of a localiser.
  [[nodiscard]] geometry::Pose true_pose() const { return held_.value_or(model_.pose()); }
  /// That stays what it is.
  void hold_true_pose(bool holds) { held_ = holds ? std::optional(model_.pose()) : std::nullopt; }
  /// Does what is due at the core's time.
  void advance();
  /// Takes the cable out: what was opened is lost for good, and nothing can be opened.
  void unplug();
  void plug();
  /// So many of the bytes to the computer [0, 1] are flipped, lost or invented; 0: as configured.
  void set_noise(double share);
  /// A share of what the wheels turn [0, 1] does not move the vehicle.
  void set_slip(double share) { model_.inputs().slip = share; }
  /// Somebody puts the vehicle to a free place up to `most_m` away and turns it; the farthest of
  /// some directions.
  void carry_off(double most_m);
  /// When the computer last sent something; Time::min() never.
  [[nodiscard]] Time commanded() const { return commanded_; }
  /// The computer's end of the line. It must not outlive the base; one at a time. Null while it is
  /// unplugged.
  [[nodiscard]] std::unique_ptr<SerialDevice> open(Devices::Readable readable);

 private:
  class Port;
  void step_model();
  void deliver();
  Core& core_;
  std::string path_;
  laser::Room room_;
  std::optional<SimLaser> laser_;
  kobuki::BaseModel model_;
  std::optional<geometry::Pose> held_;  ///< what is said of where it is
  kobuki::SerialLine line_;
  kobuki::LineParams quiet_line_;
  Time next_;
  Time commanded_ = Time::min();
  bool unplugged_ = false;
  int plugged_ = 0;
  std::vector<std::uint8_t> arrived_;
  Devices::Readable readable_;
};

}  // namespace tocsin::simulation
