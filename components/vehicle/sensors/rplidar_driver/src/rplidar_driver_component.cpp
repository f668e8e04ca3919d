// SPDX-License-Identifier: Apache-2.0
#include "rplidar_driver/rplidar_driver_component.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "foundation/error.hpp"
#include "geometry/pose.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/middleware/ros_stamp.hpp"

namespace tocsin {

using rplidar::LaserState;

namespace {

constexpr Duration diagnostics_period = std::chrono::seconds(1);

diagnostic_msgs::msg::KeyValue value(const char* key, const std::string& text) {
  diagnostic_msgs::msg::KeyValue pair;
  pair.key(key);
  pair.value(text);
  return pair;
}

std::uint8_t level_of(LaserState state) {
  namespace level = diagnostic_msgs::msg::DiagnosticStatus_Constants;
  if (state == LaserState::scanning) return level::OK;
  const bool may_become = state == LaserState::asking || state == LaserState::starting;
  return may_become ? level::WARN : level::ERROR;
}

}  // namespace

RplidarDriverComponent::RplidarDriverComponent(Context& context, const Params& params)
    : Component(context), params_(params), driver_(params.driver) {
  publish_mount();
  open_at_start();
}

RplidarDriverComponent::~RplidarDriverComponent() {
  if (!port_) return;
  for (const rplidar::Bytes& bytes : rplidar::RplidarDriver::farewell()) send(bytes);
  (void)port_->set_dtr(true);
}

void RplidarDriverComponent::publish_mount() {
  geometry_msgs::msg::TransformStamped transform;
  transform.header().stamp(wall(bus().now()));
  transform.header().frame_id(params_.base_frame);
  transform.child_frame_id(params_.frame);
  transform.transform().translation().x(params_.x_m);
  transform.transform().translation().y(params_.y_m);
  transform.transform().translation().z(params_.height_m);
  const geometry::Quaternion turned = geometry::quaternion_of(params_.yaw_rad);
  transform.transform().rotation().z(turned.z);
  transform.transform().rotation().w(turned.w);
  topic::TfStatic::Message message;
  message.transforms().push_back(transform);
  if (tf_static_.write(std::move(message)) == Status::failed) log().warn("tf_static was not sent");
}

void RplidarDriverComponent::open_at_start() {
  OpenedSerial opened = open();
  if (opened.result == OpenedSerial::Result::busy && opened.held) {
    throw ConfigError(name() + ".device_port: " + opened.reason + "; stop it or set another port");
  }
  if (opened.device) return adopt(std::move(opened.device), bus().now());
  log().warn("waiting for the laser: {}", opened.reason);
}

OpenedSerial RplidarDriverComponent::open() {
  return context().devices().try_open<SerialDevice>(params_.device_port, when_readable());
}

void RplidarDriverComponent::adopt(std::unique_ptr<SerialDevice> port, Time now) {
  if (!port->set_speed(static_cast<unsigned>(params_.baud))) {
    log().warn("{} cannot be set to {} baud", params_.device_port, params_.baud);
    return;
  }
  port_ = std::move(port);
  write_failed_ = false;
  wake_on(port_->descriptor());
  (void)port_->set_dtr(false);  // the motor of an A1 turns
  driver_.on_port_open(now);
}

void RplidarDriverComponent::retry(Time now) {
  if (now < next_retry_) return;
  next_retry_ = now + seconds(params_.retry_s);
  OpenedSerial opened = open();
  if (opened.device) adopt(std::move(opened.device), now);
}

void RplidarDriverComponent::close(const char* why) {
  log().warn("{}: {}", params_.device_port, why);
  forget(port_->descriptor());
  port_.reset();
  driver_.on_port_lost();
}

void RplidarDriverComponent::tick(Time now) {
  if (!port_) retry(now);
  if (port_) read_port(now);
  driver_.run(now, [this](const rplidar::Bytes& bytes) { send(bytes); });
  if (port_ && write_failed_) close("cannot be written");
  report(now);
  wake_at(std::min(port_ ? driver_.deadline() : next_retry_, next_diagnostics_));
}

void RplidarDriverComponent::read_port(Time now) {
  for (int reads = 0; reads < 16; ++reads) {
    const auto count = port_->read(received_.data(), received_.size());
    if (!count) return close("was lost");
    driver_.on_bytes({received_.data(), *count}, now,
                     [this](const rplidar::Turn& turn) { publish(turn); });
    if (*count < received_.size()) return;
  }
}

void RplidarDriverComponent::send(const rplidar::Bytes& bytes) {
  if (port_ && !port_->write(bytes.data(), bytes.size())) write_failed_ = true;
}

void RplidarDriverComponent::publish(const rplidar::Turn& turn) {
  if (!scan_.wanted()) return;
  const rplidar::TurnBuilder& beams = driver_.turns();
  topic::Scan::Message message;
  message.header().stamp(wall(turn.first));
  message.header().frame_id(params_.frame);
  message.angle_min(static_cast<float>(beams.first_rad()));
  message.angle_increment(static_cast<float>(beams.step_rad()));
  const auto steps = static_cast<double>(beams.beams() - 1);
  message.angle_max(static_cast<float>(beams.first_rad() + steps * beams.step_rad()));
  message.time_increment(static_cast<float>(turn.interval_s));
  message.scan_time(static_cast<float>(turn.period_s));
  message.range_min(static_cast<float>(params_.driver.turn.range_min_m));
  message.range_max(static_cast<float>(params_.driver.turn.range_max_m));
  message.ranges(turn.ranges_m);
  if (scan_.write(std::move(message)) == Status::failed) log().warn("a scan was not sent");
}

void RplidarDriverComponent::report(Time now) {
  if (const LaserState state = driver_.state(); state != reported_) {
    reported_ = state;
    const auto* text = rplidar::to_text(state);
    if (state == LaserState::scanning) {
      log().info("{}: {}", params_.device_port, driver_.info() ? to_text(*driver_.info()) : text);
    } else if (level_of(state) > 1) {
      log().warn("{}: {}; tried again", params_.device_port, text);
    }
  }
  if (now < next_diagnostics_) return;
  next_diagnostics_ = next_instant(diagnostics_period, now);
  if (diagnostics_.wanted()) publish_diagnostics(now);
}

void RplidarDriverComponent::publish_diagnostics(Time now) {
  diagnostic_msgs::msg::DiagnosticStatus status;
  status.level(level_of(driver_.state()));
  status.name(name() + ": laser");
  status.message(rplidar::to_text(driver_.state()));
  status.hardware_id(driver_.info() ? to_text(*driver_.info()) : params_.device_port);
  const rplidar::Decoder::Counts& counts = driver_.counts();
  status.values(
      {value("turn_hz", fmt::format("{:.2f}", driver_.turn_hz())),
       value("readings", std::to_string(counts.readings)),
       value("rejected", std::to_string(counts.rejected)),
       value("discarded_bytes", std::to_string(counts.discarded)),
       value("error_code", driver_.health() ? std::to_string(driver_.health()->code) : "unknown")});
  topic::Diagnostics::Message message;
  message.header().stamp(wall(now));
  message.status().push_back(status);
  if (diagnostics_.write(std::move(message)) == Status::failed) log().warn("no diagnostics sent");
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::RplidarDriverComponent)
