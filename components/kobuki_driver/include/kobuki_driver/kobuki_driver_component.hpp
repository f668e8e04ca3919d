// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "kobuki_driver/base_topics.hpp"
#include "kobuki_driver/byte_port.hpp"
#include "kobuki_driver/kobuki_driver.hpp"
#include "kobuki_driver/odometry_file.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// A Kobuki base as topics: velocity in; odometry, transform, joints, heading and battery out.
class KobukiDriverComponent final : public Component {
 public:
  struct Params {
    std::string device_port = "/dev/kobuki";
    double retry_s = 0.5;
    double battery_period_s = 1.0;
    bool publish_tf = true;
    bool publish_base_topics = true;
    std::string odom_frame = "odom";
    std::string base_frame = "base_footprint";
    kobuki::KobukiDriver::Params driver;
    template <class Visitor>
    void visit(Visitor& v) {
      v("device_port", device_port, "serial device of the base");
      v("retry_s", retry_s, {0.05, 60}, "[s] between attempts to open an absent port");
      v("battery_period_s", battery_period_s, {0.02, 60}, "[s] between battery states");
      v("publish_tf", publish_tf, "publishes the transform from odom to base");
      v("publish_base_topics", publish_base_topics,
        "publishes raw sensors, dock infrared and events of the base");
      v("odom_frame", odom_frame, "frame of odometry");
      v("base_frame", base_frame, "frame of the base");
      driver.visit(v);
    }
  };
  /// Opens the port of a path; replaced in simulated time.
  using Opener = std::function<kobuki::Opened(const std::string& path)>;

  /// Throws ConfigError when another process uses the port. An absent port is waited for.
  KobukiDriverComponent(Context& context, const Params& params);
  KobukiDriverComponent(Context& context, const Params& params, Opener opener);
  /// Leaves the base standing.
  ~KobukiDriverComponent() override;
  void tick(Time now) override;

 private:
  void open_at_start();
  void adopt(std::unique_ptr<kobuki::BytePort> port);
  void retry(Time now);
  void close(const char* why);
  void take_commands(Time now);
  void read_port(Time now);
  void send(kobuki::ByteView bytes);
  void publish(const kobuki::Reading& reading, Time now);
  void publish_battery(const kobuki::Reading& reading, Time now);
  void report_state();
  void report_versions();
  void remember(Time now);

  Input<topic::CmdVel> cmd_vel_{*this};
  Output<topic::Odom> odom_{*this};
  Output<topic::Tf> tf_{*this};
  Output<topic::JointStates> joints_{*this};
  Output<topic::Imu> imu_{*this};
  Output<topic::BatteryState> battery_{*this};
  BaseTopics base_topics_{*this};

  Params params_;
  Opener opener_;
  kobuki::KobukiDriver driver_;
  kobuki::OdometryFile file_;
  std::unique_ptr<kobuki::BytePort> port_;
  bool write_failed_ = false;
  bool versions_reported_ = false;
  kobuki::BaseState reported_ = kobuki::BaseState::no_port;
  Time next_retry_ = Time::min();
  Time next_battery_ = Time::min();
  Time next_save_ = Time::min();
};

}  // namespace tocsin
