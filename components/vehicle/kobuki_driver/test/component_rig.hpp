// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "devices/computer.hpp"
#include "kobuki_driver/kobuki_driver_component.hpp"
#include "kobuki_model/base_model.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {

/// A base in the bus's virtual time and the cable to it.
struct Base {
  explicit Base(const SimBus& clock)
      : bus(clock), model({}, kobuki::open_floor(), {}, 1, bus.now()) {}
  const SimBus& bus;
  kobuki::BaseModel model;
  std::vector<std::uint8_t> arrived;
  bool plugged = true;
};

class ModelPort final : public SerialDevice {
 public:
  explicit ModelPort(Base& base) : base_(base) {}
  std::optional<std::size_t> read(std::uint8_t* to, std::size_t size) override {
    base_.model.step(base_.bus.now(), [this](Time, ByteView frame) {
      base_.arrived.insert(base_.arrived.end(), frame.begin(), frame.end());
    });
    if (!base_.plugged) return std::nullopt;
    const std::size_t count = std::min(size, base_.arrived.size());
    std::copy_n(base_.arrived.begin(), count, to);
    base_.arrived.erase(base_.arrived.begin(),
                        base_.arrived.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  bool write(const std::uint8_t* bytes, std::size_t size) override {
    base_.model.receive({bytes, size}, base_.bus.now());
    return base_.plugged;
  }

 private:
  Base& base_;
};

/// A computer with one base on /dev/kobuki, while it is plugged.
struct ModelDevices {
  explicit ModelDevices(Base& base) {
    computer.keeps_files = true;
    computer.devices.add<SerialDevice>(
        [this, &base](const std::string& path, Devices::Readable on) -> OpenedSerial {
          ++attempts;
          readable = std::move(on);
          if (in_use) return {OpenedSerial::Result::busy, *in_use, held};
          if (!base.plugged || path != "/dev/kobuki") return {};
          return std::make_unique<ModelPort>(base);
        });
  }
  Computer computer;
  Devices::Readable readable;
  int attempts = 0;
  std::optional<std::string> in_use;  ///< why the port is busy
  bool held = false;                  ///< by a living process
};

class KobukiDriverComponentTest : public ::testing::Test {
 protected:
  void start() { sut_ = std::make_unique<KobukiDriverComponent>(context_, params_); }
  void run(double duration_s, double v_mps = 0, bool commanded = false) {
    for (int i = 0; i < std::lround(duration_s / 0.01); ++i) {
      if (commanded && i % 5 == 0) {
        topic::CmdVel::Message command;
        command.linear().x(v_mps);
        bus_.publish<topic::CmdVel>(command);
      }
      if (sut_) sut_->tick(bus_.now());
      bus_.run_for(std::chrono::milliseconds(10));
    }
  }
  void drive(double duration_s, double v_mps) { run(duration_s, v_mps, true); }

  SimBus bus_;
  Base base_{bus_};
  ModelDevices devices_{base_};
  Context context_ = Context(bus_, "kobuki_driver", Role::uxv).with_computer(devices_.computer);
  KobukiDriverComponent::Params params_;
  std::unique_ptr<KobukiDriverComponent> sut_;
  SimReader<topic::Odom> odom_{bus_};
  SimReader<topic::Tf> tf_{bus_};
  SimReader<topic::JointStates> joints_{bus_};
  SimReader<topic::Imu> imu_{bus_};
  SimReader<topic::BatteryState> battery_{bus_};
};

}  // namespace tocsin
