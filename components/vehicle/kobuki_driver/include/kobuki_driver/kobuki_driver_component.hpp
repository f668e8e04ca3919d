// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "devices/serial_device.hpp"
#include "emergency_stop_input/emergency_stop_input.hpp"
#include "emergency_stop_input/stop_file.hpp"
#include "kobuki_driver/base_topics.hpp"
#include "kobuki_driver/command_topics.hpp"
#include "kobuki_driver/frame_topics.hpp"
#include "kobuki_driver/kobuki_driver.hpp"
#include "kobuki_driver/odometry_file.hpp"
#include "kobuki_driver/serial_topics.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// A Kobuki base as topics: velocity and commands in; odometry, sensors, events and health out.
/// Holds the emergency stop itself: while one stands the base stands, whoever publishes velocities.
class KobukiDriverComponent final : public Component {
 public:
  struct Params {
    std::string device_port = "/dev/kobuki";
    double retry_s = 0.5;
    bool publish_base_topics = true;
    bool publish_serial_bytes = false;
    FrameParams frame;
    kobuki::KobukiDriver::Params driver;
    template <class Visitor>
    void visit(Visitor& v) {
      v("device_port", device_port, "serial device of the base");
      v("retry_s", retry_s, {0.05, 60}, "[s] between attempts to open an absent port");
      v("publish_base_topics", publish_base_topics,
        "publishes raw sensors, raw gyro, dock infrared and events of the base");
      v("publish_serial_bytes", publish_serial_bytes,
        "publishes what comes and goes over the port as hexadecimal text");
      frame.visit(v);
      driver.visit(v);
    }
  };
  /// Throws ConfigError when another process uses the port. An absent port is waited for.
  KobukiDriverComponent(Context& context, const Params& params);
  /// Leaves the base standing.
  ~KobukiDriverComponent() override;
  void tick(Time now) override;

 private:
  void open_at_start();
  [[nodiscard]] OpenedSerial open();
  void adopt(std::unique_ptr<SerialDevice> port);
  void retry(Time now);
  void close(const char* why);
  void take_emergency_stop(Time now);
  void take_commands(Time now);
  void read_port(Time now);
  /// Ticks with the next byte.
  void listen();
  /// Ticks when the frame under way should be whole; with the next byte, where none is, or where
  /// nothing more of it came.
  void await_bytes(bool more_came, Time now);
  void send(ByteView bytes);
  void publish(const kobuki::Reading& reading, Time now);
  /// Tells what of state, versions and gains has changed.
  void report();
  void report_state();
  void report_versions();
  void report_gains();
  void remember(Time now);

  Input<topic::CmdVel> cmd_vel_{*this, WakeMode::time_triggered};
  EmergencyStopInput emergency_stop_{*this};
  CommandTopics commands_{*this};
  BaseTopics base_topics_{*this};

  Params params_;
  FrameTopics frame_topics_;
  std::optional<SerialTopics> serial_topics_;
  kobuki::KobukiDriver driver_;
  const kobuki::KobukiDriver::ByteSink to_port_ = [this](ByteView bytes) { send(bytes); };
  kobuki::OdometryFile file_;
  StopFile stop_file_;
  std::unique_ptr<SerialDevice> port_;
  std::array<std::uint8_t, 1024> received_{};
  bool write_failed_ = false;
  bool versions_reported_ = false;
  bool gains_reported_ = false;
  kobuki::BaseState reported_ = kobuki::BaseState::no_port;
  Time next_read_ = never;  ///< of the rest of a frame; until then no byte wakes it
  Time next_retry_ = Time::min();
  Time next_save_ = Time::min();
  bool saved_ = true;
};

}  // namespace tocsin
