// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "runtime/bus.hpp"

namespace tocsin::bench {

/// A bus that calls back before each write of odometry and leaves the rest to another bus.
class OdomWatch final : public Bus {
 public:
  OdomWatch(Bus& bus, std::function<void()> on_odom) : bus_(bus), on_odom_(std::move(on_odom)) {}
  std::unique_ptr<Subscription> subscribe(const Endpoint& endpoint, Receiver& receiver) override {
    return bus_.subscribe(endpoint, receiver);
  }
  std::unique_ptr<Publication> advertise(const Endpoint& endpoint) override;
  [[nodiscard]] Time now() const override { return bus_.now(); }
  [[nodiscard]] std::int64_t wall_ns(Time t) const override { return bus_.wall_ns(t); }

 private:
  Bus& bus_;
  std::function<void()> on_odom_;
};

}  // namespace tocsin::bench
