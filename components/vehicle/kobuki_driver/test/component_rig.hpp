// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "kobuki_driver/kobuki_driver_component.hpp"
#include "kobuki_model/base_model.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {

using kobuki::ByteView;
using kobuki::Opened;

/// A base in the bus's virtual time and the cable to it.
struct Base {
  explicit Base(const SimBus& clock)
      : bus(clock), model({}, kobuki::open_floor(), {}, 1, bus.now()) {}
  const SimBus& bus;
  kobuki::BaseModel model;
  std::vector<std::uint8_t> arrived;
  bool plugged = true;
};

class ModelPort final : public kobuki::BytePort {
 public:
  explicit ModelPort(Base& base) : base_(base) {}
  int descriptor() const override { return -1; }
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
  bool write(ByteView bytes) override {
    base_.model.receive(bytes, base_.bus.now());
    return base_.plugged;
  }

 private:
  Base& base_;
};

class KobukiDriverComponentTest : public ::testing::Test {
 protected:
  void start() {
    sut_ = std::make_unique<KobukiDriverComponent>(context_, params_,
                                                   [this](const std::string&) { return open(); });
  }
  Opened open() {
    ++attempts_;
    if (!base_.plugged) return {Opened::Result::absent, nullptr, "no such file", false};
    return {Opened::Result::open, std::make_unique<ModelPort>(base_), {}, false};
  }
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
  Context context_{bus_, "kobuki_driver", "uxv", ""};
  KobukiDriverComponent::Params params_;
  Base base_{bus_};
  int attempts_ = 0;
  std::unique_ptr<KobukiDriverComponent> sut_;
  SimReader<topic::Odom> odom_{bus_};
  SimReader<topic::Tf> tf_{bus_};
  SimReader<topic::JointStates> joints_{bus_};
  SimReader<topic::Imu> imu_{bus_};
  SimReader<topic::BatteryState> battery_{bus_};
};

}  // namespace tocsin
