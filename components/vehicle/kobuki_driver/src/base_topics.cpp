// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/base_topics.hpp"

#include <utility>

#include "base_commands.hpp"
#include "kobuki_protocol/gyro.hpp"
#include "messages.hpp"

namespace tocsin {
namespace {

using namespace kobuki_ros_interfaces::msg;

std::uint8_t index_of(kobuki::Side side) { return static_cast<std::uint8_t>(side); }
std::uint8_t code_of(bool state) { return state ? 1 : 0; }

SensorState sensor_message(const kobuki::Feedback& feedback, const std_msgs::msg::Header& header) {
  const kobuki::CoreSensors& core = *feedback.core;
  SensorState message;
  message.header(header);
  message.time_stamp(core.timestamp_ms);
  message.bumper(core.bumper);
  message.wheel_drop(core.wheel_drop);
  message.cliff(core.cliff);
  message.left_encoder(core.left_encoder);
  message.right_encoder(core.right_encoder);
  message.left_pwm(core.left_pwm);
  message.right_pwm(core.right_pwm);
  message.buttons(core.buttons);
  message.charger(core.charger);
  message.battery(core.battery_dv);
  message.over_current(core.over_current);
  if (const auto& adc = feedback.cliff_adc) message.bottom({adc->right, adc->centre, adc->left});
  if (const auto& current = feedback.current) message.current({current->left, current->right});
  if (const auto& input = feedback.input) {
    message.digital_input(input->digital);
    message.analog_input({input->analog.begin(), input->analog.end()});
  }
  return message;
}

}  // namespace

/// Writes each kind of event to its topic.
struct BaseTopics::EventWriter {
  BaseTopics& to;

  Status operator()(const kobuki::ButtonEvent& event) {
    ButtonEvent message;
    message.button(static_cast<std::uint8_t>(event.button));
    message.state(code_of(event.pressed));
    return to.buttons_.write(message);
  }
  Status operator()(const kobuki::BumperEvent& event) {
    BumperEvent message;
    message.bumper(index_of(event.side));
    message.state(code_of(event.pressed));
    return to.bumpers_.write(message);
  }
  Status operator()(const kobuki::CliffEvent& event) {
    CliffEvent message;
    message.sensor(index_of(event.side));
    message.state(code_of(event.cliff));
    message.bottom(event.adc);
    return to.cliffs_.write(message);
  }
  Status operator()(const kobuki::WheelDropEvent& event) {
    WheelDropEvent message;
    message.wheel(code_of(event.side == kobuki::Side::right));
    message.state(code_of(event.dropped));
    return to.wheels_.write(message);
  }
  Status operator()(kobuki::PowerEvent event) {
    PowerSystemEvent message;
    message.event(static_cast<std::uint8_t>(event));
    return to.power_.write(message);
  }
  Status operator()(const kobuki::InputEvent& event) {
    DigitalInputEvent message;
    message.values(event.values);
    return to.inputs_.write(message);
  }
};

BaseTopics::BaseTopics(Component& owner)
    : bus_(owner.bus()),
      sensors_(owner),
      dock_(owner),
      buttons_(owner),
      bumpers_(owner),
      cliffs_(owner),
      wheels_(owner),
      power_(owner),
      inputs_(owner),
      robot_state_(owner),
      versions_(owner),
      gains_(owner),
      gyro_(owner) {}

bool BaseTopics::publish(const kobuki::Reading& reading, const FrameTopics& frames, Time now) {
  bool ok = true;
  if (sensors_.wanted()) {
    ok = sensors_.write(sensor_message(reading.feedback, frames.header(now))) != Status::failed;
  }
  const auto& gyro = reading.feedback.gyro;
  if (gyro && gyro_.wanted()) ok &= publish_gyro(*gyro, now);
  const auto& dock = reading.feedback.dock_infrared;
  if (dock && dock_.wanted()) ok &= publish_dock(*dock, frames.header(now));
  for (const kobuki::Event& event : reading.events) {
    ok &= std::visit(EventWriter{*this}, event) != Status::failed;
  }
  return ok;
}

bool BaseTopics::publish_gyro(const kobuki::RawGyro& gyro, Time now) {
  bool ok = true;
  for (int i = 0; i < gyro.count; ++i) {
    const Time taken = kobuki::gyro_sample_time(now, i, gyro.count);
    ok &= gyro_.write(kobuki::raw_imu_message(gyro.samples[static_cast<std::size_t>(i)],
                                              bus_.wall_ns(taken))) != Status::failed;
  }
  return ok;
}

bool BaseTopics::publish_dock(const kobuki::DockInfrared& dock,
                              const std_msgs::msg::Header& header) {
  DockInfraRed message;
  message.header(header);
  message.header().frame_id("dock_ir_link");
  message.data({dock.right, dock.centre, dock.left});
  return dock_.write(std::move(message)) != Status::failed;
}

bool BaseTopics::publish_state(bool online) {
  RobotStateEvent message;
  message.state(code_of(online));
  return robot_state_.write(message) != Status::failed;
}

bool BaseTopics::publish_versions(const kobuki::Inquiry& inquiry) {
  VersionInfo message;
  message.hardware(to_text(*inquiry.hardware()));
  message.firmware(to_text(*inquiry.firmware()));
  message.software("tocsin " TOCSIN_VERSION);
  message.udid({inquiry.unique_id()->begin(), inquiry.unique_id()->end()});
  message.features(feature_bits(*inquiry.firmware()));
  return versions_.write(std::move(message)) != Status::failed;
}

bool BaseTopics::publish_gains(const kobuki::ControllerGains& gains) {
  return gains_.write(kobuki::to_message(gains)) != Status::failed;
}

}  // namespace tocsin
