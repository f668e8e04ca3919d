// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/kobuki_driver_component.hpp"

#include <algorithm>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {

using kobuki::BaseState;
using kobuki::Reading;

namespace {

constexpr Duration save_period = std::chrono::milliseconds(200);

const char* text_of(BaseState state) {
  switch (state) {
    case BaseState::no_port:
      return "offline: the port is lost";
    case BaseState::silent:
      return "offline: it sends nothing";
    case BaseState::online:
      return "online";
    case BaseState::refused:
      break;
  }
  return "refused: its firmware is not of major version 1";
}

}  // namespace

KobukiDriverComponent::KobukiDriverComponent(Context& context, const Params& params)
    : Component(context),
      params_(params),
      frame_topics_(*this, params.frame, params.driver.odometry.use_gyro_heading),
      driver_(params.driver),
      file_(context.state_path(".odometry")),
      stop_file_(context.state_path(".stop")) {
  if (params.publish_serial_bytes) serial_topics_.emplace(*this);
  if (const auto memory = file_.load()) driver_.resume(memory->odometry, memory->taken);
  emergency_stop_.restore(stop_file_.load(), bus().now());
  driver_.on_emergency_stop(emergency_stop_.stands(), bus().now());
  if (driver_.emergency_stop()) log().warn("the emergency stop stands, as before the restart");
  open_at_start();
}

KobukiDriverComponent::~KobukiDriverComponent() {
  if (port_) driver_.farewell(to_port_);
}

void KobukiDriverComponent::open_at_start() {
  OpenedSerial opened = open();
  // Without a living holder it is a leftover of a killed process, which the retries outlast.
  if (opened.result == OpenedSerial::Result::busy && opened.held) {
    throw ConfigError(name() + ".device_port: " + opened.reason + "; stop it or set another port");
  }
  if (opened.device) return adopt(std::move(opened.device));
  log().warn("waiting for the base: {}", opened.reason);
}

OpenedSerial KobukiDriverComponent::open() {
  return context().devices().try_open<SerialDevice>(params_.device_port, when_readable());
}

void KobukiDriverComponent::adopt(std::unique_ptr<SerialDevice> port) {
  port_ = std::move(port);
  write_failed_ = false;
  listen();
  driver_.on_port_open();
}

void KobukiDriverComponent::listen() {
  forget(port_->descriptor());
  wake_on(port_->descriptor());
  next_read_ = never;
}

/// A frame of 90 bytes comes in eight portions within 8 ms: one look at its end does.
void KobukiDriverComponent::await_bytes(bool more_came, Time now) {
  constexpr Duration margin = std::chrono::microseconds(500);
  const Duration rest = driver_.rest_of_frame();
  if (!more_came || rest == Duration{0} || !port_->descriptor()) return listen();
  forget(port_->descriptor());
  next_read_ = now + rest + margin;
}

void KobukiDriverComponent::retry(Time now) {
  if (now < next_retry_) return;
  next_retry_ = now + seconds(params_.retry_s);
  OpenedSerial opened = open();
  if (opened.device) adopt(std::move(opened.device));
}

void KobukiDriverComponent::close(const char* why) {
  log().warn("{}: {}", params_.device_port, why);
  forget(port_->descriptor());
  next_read_ = never;
  port_.reset();
  driver_.on_port_lost();
}

void KobukiDriverComponent::tick(Time now) {
  if (!port_) retry(now);
  if (port_) read_port(now);
  take_emergency_stop(now);
  take_commands(now);
  driver_.run(now, to_port_);
  if (port_ && write_failed_) close("cannot be written");
  report();
  if (!frame_topics_.publish_diagnostics(driver_, now)) log().warn("no diagnostics published");
  remember(now);
  wake_at(std::min({port_ ? driver_.next_deadline() : next_retry_, frame_topics_.next_diagnostics(),
                    emergency_stop_.deadline(), next_read_}));
}

void KobukiDriverComponent::take_emergency_stop(Time now) {
  if (emergency_stop_.take(now)) {
    driver_.on_emergency_stop(emergency_stop_.stands(), now);
    log().warn("emergency stop {} {}", emergency_stop_.stands() ? "ON: the base stands;" : "off",
               joined(emergency_stop_.stopped_by()));
  }
  if (!stop_file_.save(emergency_stop_.memory())) {
    log().warn("the emergency stop cannot be kept for a restart");
  }
}

void KobukiDriverComponent::take_commands(Time now) {
  while (const auto command = cmd_vel_.take()) {
    driver_.on_velocity({command->linear().x(), command->angular().z()}, now);
  }
  if (const int refused = commands_.apply(driver_)) log().warn("{} commands refused", refused);
}

void KobukiDriverComponent::read_port(Time now) {
  bool more_came = false;
  for (int reads = 0; reads < 16; ++reads) {  // bounded: commands must not wait for a flood
    const auto count = port_->read(received_.data(), received_.size());
    if (!count) return close("was lost");
    if (*count == 0) break;
    more_came = true;
    const ByteView bytes{received_.data(), *count};
    if (serial_topics_ && !serial_topics_->received(bytes)) {
      log().warn("received bytes were not published");
    }
    driver_.on_bytes(bytes, now, [&](const Reading& reading) { publish(reading, now); });
    if (*count < received_.size()) break;  // no more waits; what comes now wakes us again
  }
  await_bytes(more_came, now);
}

void KobukiDriverComponent::send(ByteView bytes) {
  if (!port_) return;
  if (!port_->write(bytes.data, bytes.size)) write_failed_ = true;
  if (serial_topics_ && !serial_topics_->sent(bytes)) log().warn("sent bytes were not published");
}

void KobukiDriverComponent::publish(const Reading& reading, Time now) {
  bool ok = frame_topics_.publish(reading, now);
  if (params_.publish_base_topics) {
    ok &= base_topics_.publish(reading, frame_topics_, now);
  }
  if (!ok) log().warn("a reading was not published");
}

void KobukiDriverComponent::report() {
  const kobuki::Inquiry& inquiry = driver_.inquiry();
  if (driver_.state() != reported_) report_state();
  const bool known = inquiry.hardware() && inquiry.firmware() && inquiry.unique_id();
  if (std::exchange(versions_reported_, known) != known && known) report_versions();
  const bool have_gains = inquiry.gains().has_value();
  if (std::exchange(gains_reported_, have_gains) != have_gains && have_gains) report_gains();
}

void KobukiDriverComponent::report_state() {
  const bool just_opened = reported_ == BaseState::no_port && driver_.state() == BaseState::silent;
  reported_ = driver_.state();
  if (just_opened) return;  // the first frame is on its way
  const bool sent = base_topics_.publish_state(reported_ == BaseState::online);
  if (!sent) log().warn("the robot state was not published");
  if (reported_ == BaseState::online) {
    log().info("the base on {} is online", params_.device_port);
  } else {
    log().warn("the base on {} is {}", params_.device_port, text_of(reported_));
  }
}

void KobukiDriverComponent::report_versions() {
  const kobuki::Inquiry& inquiry = driver_.inquiry();
  log().info("hardware {}, firmware {}", to_text(*inquiry.hardware()),
             to_text(*inquiry.firmware()));
  const auto support = judge_firmware(*inquiry.firmware());
  if (support == kobuki::FirmwareSupport::replace) {
    log().warn("this firmware should be replaced by 1.1.4 or 1.2.0");
  }
  if (support == kobuki::FirmwareSupport::software_behind) {
    log().warn("this firmware is newer than any that this software knows");
  }
  if (!base_topics_.publish_versions(inquiry)) log().warn("the versions were not published");
}

void KobukiDriverComponent::report_gains() {
  const bool sent = base_topics_.publish_gains(*driver_.inquiry().gains());
  if (!sent) log().warn("the gains were not published");
}

void KobukiDriverComponent::remember(Time now) {
  if (now < next_save_) return;
  const auto snapshot = driver_.odometry().snapshot();
  if (!snapshot || driver_.odometry().waits()) return;
  next_save_ = now + save_period;
  const bool saved = file_.save({*snapshot, driver_.odometry_time()});
  if (std::exchange(saved_, saved) && !saved) log().warn("odometry cannot be saved for a restart");
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::KobukiDriverComponent)
