// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "kobuki_model/base_model.hpp"
#include "kobuki_model/serial_line.hpp"

namespace tocsin::kobuki {

/// A base, its serial line and its cable. Pure; `now` must not decrease.
class SimulatedBase {
 public:
  SimulatedBase(BaseModel model, SerialLine line)
      : model_(std::move(model)), line_(std::move(line)) {}

  /// Bytes from the computer; lost while the cable is out.
  void receive(ByteView bytes, Time now);
  /// Moves the world to `now` and hands over what arrives at the computer.
  void step(Time now, const SerialLine::Sink& sink);
  /// When `step` has something to do next.
  [[nodiscard]] Time next_event() const;

  /// Pulls the cable until `plug`; with a duration it is put back by itself.
  void unplug(Time now, Duration duration);
  void plug() { plug_at_ = Time::min(); }
  [[nodiscard]] bool plugged(Time now) const { return now >= plug_at_; }
  /// The base sends nothing for a time, but goes on moving.
  void silence(Time now, Duration duration) { silent_until_ = now + duration; }
  /// Switches the base off and on; it is silent for a second.
  void power_cycle(Time now);

  [[nodiscard]] BaseModel& model() { return model_; }
  [[nodiscard]] SerialLine& line() { return line_; }

 private:
  BaseModel model_;
  SerialLine line_;
  Time plug_at_ = Time::min();
  Time silent_until_ = Time::min();
};

}  // namespace tocsin::kobuki
