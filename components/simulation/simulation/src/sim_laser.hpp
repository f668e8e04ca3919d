// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "core.hpp"
#include "devices/devices.hpp"
#include "devices/serial_device.hpp"
#include "laser_model/simulated_laser.hpp"
#include "simulation/faults.hpp"

namespace tocsin::simulation {

/// What the command line of kobuki_simulator says of a laser.
struct LaserOptions {
  std::string link;  ///< path of its serial port; empty: none
  std::string profile = "rplidar_a1";
  geometry::Pose mount;
};

/// The laser of a simulated base behind a serial port in virtual time.
class SimLaser {
 public:
  /// Throws ConfigError for an unknown profile.
  SimLaser(Core& core, const LaserOptions& options, std::shared_ptr<const laser::Scene> scene,
           std::uint64_t seed);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] Time next_event() const;
  /// Does what is due at the core's time, on a vehicle that moves like this.
  void advance(const laser::SimulatedLaser::Motion& motion);
  /// The computer's end of the line. It must not outlive the laser; one at a time. Null while it is
  /// unplugged.
  [[nodiscard]] std::unique_ptr<SerialDevice> open(Devices::Readable readable);
  /// One of the faults of lasers.
  void begin(const Fault& fault) { set(fault, true); }
  void end(const Fault& fault) { set(fault, false); }

 private:
  class Port;
  struct Sent {
    Time arrives;
    std::vector<std::uint8_t> bytes;
  };
  void set(const Fault& fault, bool holds);
  void set_plugged(bool plugged);
  void deliver();
  Core& core_;
  std::string path_;
  laser::SimulatedLaser laser_;
  Duration delay_{};
  std::deque<Sent> sent_;
  std::vector<std::uint8_t> arrived_;
  bool is_plugged_ = true;
  int plugged_ = 0;  ///< how often it was
  Devices::Readable readable_;
};

}  // namespace tocsin::simulation
