// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "devices/serial_device.hpp"
#include "rplidar_driver/rplidar_driver.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// A Slamtec RPLIDAR A1 or A2 as the topic `scan`, where it sits on the vehicle, and how it is.
class RplidarDriverComponent final : public Component {
 public:
  struct Params {
    std::string device_port = "/dev/rplidar";
    int baud = 115200;
    double retry_s = 0.5;
    std::string frame = "laser";
    std::string base_frame = "base_footprint";
    double x_m = 0;
    double y_m = 0;
    double height_m = 0.2;
    double yaw_rad = 0;
    rplidar::RplidarDriver::Params driver;
    template <class Visitor>
    void visit(Visitor& v) {
      v("device_port", device_port, "serial device of the laser");
      v("baud", baud, {9600, 1000000}, "[Bd] 115200: A1 and A2M8; 256000: A2M7 and A2M12");
      v("retry_s", retry_s, {0.05, 60}, "[s] between attempts to open an absent port");
      v("frame", frame, "of the scans");
      v("base_frame", base_frame, "that the laser is mounted on");
      v("x_m", x_m, {-5, 5}, "[m] of the laser on the vehicle, ahead");
      v("y_m", y_m, {-5, 5}, "[m] to the left");
      v("height_m", height_m, {0, 5}, "[m] above the floor");
      v("yaw_rad", yaw_rad, {-7, 7}, "[rad] that its ahead is turned to the left");
      driver.visit(v);
    }
  };
  /// Throws ConfigError when another process uses the port, or the parameters contradict each
  /// other. An absent port is waited for.
  RplidarDriverComponent(Context& context, const Params& params);
  /// Leaves the laser at rest.
  ~RplidarDriverComponent() override;
  void tick(Time now) override;

 private:
  void publish_mount();
  void open_at_start();
  [[nodiscard]] OpenedSerial open();
  void adopt(std::unique_ptr<SerialDevice> port, Time now);
  void retry(Time now);
  void close(const char* why);
  void read_port(Time now);
  void send(const rplidar::Bytes& bytes);
  void publish(const rplidar::Turn& turn);
  void report(Time now);
  void publish_diagnostics(Time now);

  Output<topic::Scan> scan_{*this};
  Output<topic::TfStatic> tf_static_{*this};
  Output<topic::Diagnostics> diagnostics_{*this};

  Params params_;
  rplidar::RplidarDriver driver_;
  std::unique_ptr<SerialDevice> port_;
  std::array<std::uint8_t, 4096> received_{};
  bool write_failed_ = false;
  rplidar::LaserState reported_ = rplidar::LaserState::no_port;
  Time next_retry_ = Time::min();
  Time next_diagnostics_ = Time::min();
};

}  // namespace tocsin
