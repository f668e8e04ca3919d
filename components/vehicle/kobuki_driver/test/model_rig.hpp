// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "geometry/twist.hpp"
#include "kobuki_driver/kobuki_driver.hpp"
#include "kobuki_model/base_model.hpp"
#include "kobuki_model/serial_line.hpp"

namespace tocsin::kobuki {

inline ModelParams exact_model() {
  ModelParams params;
  params.command_delay_s = 0;
  params.acceleration_mps2 = 20;
  params.slip_sigma = 0;
  params.gyro_drift_deg_per_sqrt_s = 0;
  params.gyro_noise_dps = 0;
  return params;
}

/// A driver and a base on a virtual line, in virtual time, 1 ms a step.
struct ModelRig {
  explicit ModelRig(const KobukiDriver::Params& params = {},
                    const ModelParams& base = exact_model(), const LineParams& cable = {})
      : driver(params), model(base, open_floor(), {}, 1, now), line(cable, 2, now) {
    driver.on_port_open();
  }

  void run(double duration_s, std::optional<geometry::Twist> command = {}) {
    const Time end = now + seconds(duration_s);
    while (now < end) {
      now += std::chrono::milliseconds(1);
      const bool command_due =
          command && (now.time_since_epoch() / std::chrono::milliseconds(1)) % 50 == 0;
      if (command_due) driver.on_velocity(*command, now);
      step();
    }
  }

  void step() {
    model.step(now, [&](Time at, ByteView frame) {
      if (!silent) line.send(frame, at);
    });
    line.deliver(now, [&](ByteView bytes) {
      driver.on_bytes(bytes, now, [&](const Reading& reading) {
        last = reading;
        ++readings;
      });
    });
    driver.run(now, [&](ByteView bytes) { on_command_bytes(bytes); });
  }

  void on_command_bytes(ByteView bytes) {
    if (connected) model.receive(bytes, now);
    sent.feed(bytes, [&](ByteView payload) {
      decode_commands(payload, counts, [&](const Command& command) {
        commands.push_back(command);
        times.push_back(now);
      });
    });
  }

  template <class T>
  [[nodiscard]] int count() const {
    return static_cast<int>(std::count_if(commands.begin(), commands.end(), [](const Command& c) {
      return std::holds_alternative<T>(c);
    }));
  }

  Time now = Time{} + seconds(1000);
  KobukiDriver driver;
  BaseModel model;
  SerialLine line;
  bool silent = false;
  bool connected = true;
  Reading last;
  int readings = 0;
  Reassembler sent;
  DecodeCounts counts;
  std::vector<Command> commands;
  std::vector<Time> times;
};

}  // namespace tocsin::kobuki
