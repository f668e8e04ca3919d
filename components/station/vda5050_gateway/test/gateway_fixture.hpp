// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "order_texts.hpp"
#include "vda5050_gateway/gateway.hpp"

namespace tocsin::vda5050 {

/// A gateway, a vehicle that stands at node a, and a fleet manager.
class GatewayFixture {
 public:
  explicit GatewayFixture(Version version = Version::v3_0) : texts(version), sut(params(version)) {
    vehicle.pose = geometry::Pose{};
    vehicle.navigation = "idle";
    vehicle.mission = "idle";
    vehicle.charge_percent = 80;
    vehicle.silence_s = 0.1;
    step();
  }
  static Gateway::Params params(Version version) {
    Gateway::Params made;
    made.identity = OrderTexts(version).identity();
    return made;
  }

  void order(const nlohmann::json& text) {
    sut.on_order(text.dump(), vehicle);
    step();
  }
  /// With a number of its own.
  std::string instant(const std::string& type, const nlohmann::json& parameters = {}) {
    const std::string id = "i" + std::to_string(++instants_);
    sut.on_instant_actions(texts.instant(type, id, parameters), vehicle, now);
    step();
    return id;
  }
  void news(DriveNews::Kind kind, std::uint32_t index = 0, const std::string& reason = "") {
    sut.on_drive({kind, index, reason}, now);
    step();
  }
  void step(double s = 0.1) {
    now += seconds(s);
    for (Request& request : sut.update(vehicle, now)) requests.push_back(std::move(request));
  }
  void wait(double s) {
    for (double passed = 0; passed < s; passed += 0.1) step();
  }
  std::vector<Request> take() { return std::exchange(requests, {}); }
  /// x of its poses, of the only request, which is a drive.
  [[nodiscard]] std::vector<double> take_drive() {
    const auto all = take();
    EXPECT_EQ(all.size(), 1u);
    std::vector<double> places;
    if (all.size() != 1) return places;
    EXPECT_EQ(all[0].kind, Request::Kind::drive);
    for (const geometry::Pose& pose : all[0].poses) places.push_back(pose.x_m);
    return places;
  }
  [[nodiscard]] ActionStatus status(const std::string& id) const {
    for (const ActionState& state : sut.instant_actions()) {
      if (state.action.id == id) return state.status;
    }
    for (const ActionState& state : sut.order().actions()) {
      if (state.action.id == id) return state.status;
    }
    ADD_FAILURE() << "there is no action " << id;
    return ActionStatus::failed;
  }
  [[nodiscard]] std::vector<ErrorType> errors() const {
    std::vector<ErrorType> all;
    for (const Fault& fault : sut.faults(vehicle)) all.push_back(fault.type);
    return all;
  }

  const OrderTexts texts;
  Vehicle vehicle;
  Gateway sut;
  Time now{seconds(100)};
  std::vector<Request> requests;

 private:
  int instants_ = 0;
};

}  // namespace tocsin::vda5050
