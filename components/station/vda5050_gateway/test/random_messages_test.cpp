// SPDX-License-Identifier: Apache-2.0
// Random orders, actions and events. TOCSIN_VDA5050_STEPS sets how many; TOCSIN_VDA5050_FILE is
// where all messages are written, as test/interop/vda5050_schemas.py reads them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <random>

#include "gateway_fixture.hpp"
#include "vda5050_gateway/messages.hpp"

namespace tocsin::vda5050 {
namespace {

using nlohmann::json;
using Kind = Request::Kind;
using News = DriveNews::Kind;

constexpr std::int64_t noon_ns = 1796126400'000'000'000;

std::string environment(const char* name, const char* otherwise) {
  const char* value = std::getenv(name);
  return value == nullptr ? otherwise : value;
}

class Site {
 public:
  Site(Version version, std::uint32_t seed, std::ostream* file)
      : rig_(version), publications_(rig_.texts.identity(), {}), random_(seed), file_(file) {
    publications_.on_connected();
  }
  void step() {
    const std::uint32_t event = below(8);
    if (event < 2) send_order();
    if (event == 2) send_action();
    if (event == 3) change_vehicle();
    if (event >= 4) drive();
    rig_.step(0.1 * (1 + below(4)));
    publish();
  }
  int sent = 0;
  int not_taken = 0;
  int taken = 0;
  int mutated = 0;

 private:
  std::uint32_t below(std::uint32_t bound) { return static_cast<std::uint32_t>(random_() % bound); }

  void publish() {
    for (const Message& message : publications_.due(
             rig_.sut, rig_.vehicle, rig_.now, noon_ns + rig_.now.time_since_epoch().count())) {
      ++sent;
      ASSERT_TRUE(json::accept(message.payload)) << message.payload;
      tell(message.topic, message.payload, false);
    }
  }
  void tell(const std::string& topic, const std::string& payload, bool is_refused) {
    if (file_ == nullptr) return;
    *file_ << json{{"topic", topic}, {"payload", payload}, {"refused", is_refused}}.dump(
                  -1, ' ', false, json::error_handler_t::replace)
           << '\n';
  }
  /// What an order that is refused must not change.
  [[nodiscard]] json held() const {
    json state = state_body(rig_.sut, rig_.vehicle);
    json all;
    for (const char* name :
         {"orderId", "orderUpdateId", "lastNodeId", "nodeStates", "edgeStates", "actionStates"}) {
      all[name] = state[name];
    }
    return all;
  }

  /// An update of the present order, a repetition, or a new one from where the vehicle stands.
  json next_order() {
    const OrderBook& book = rig_.sut.order();
    const bool is_new = book.is_idle() && below(3) != 0;
    const auto node = is_new ? static_cast<int>(std::clamp(rig_.vehicle.pose->x_m + 0.5, 0.0, 20.0))
                             : last_of_base();
    const int nodes = 1 + static_cast<int>(below(5));
    const auto released = 1 + static_cast<int>(below(static_cast<std::uint32_t>(nodes)));
    json order = rig_.texts.order(nodes, released, node);
    order["orderId"] = is_new ? "o" + std::to_string(++orders_) : book.id();
    order["orderUpdateId"] = is_new ? 0 : book.update() + below(3);
    if (is_new) number(order);
    if (below(4) == 0) {
      order["nodes"].back()["actions"].push_back(
          OrderTexts::action("startCharging", "c" + std::to_string(++actions_)));
    }
    return order;
  }
  /// From 0, wherever it begins.
  static void number(json& order) {
    for (std::size_t i = 0; i < order["nodes"].size(); ++i) {
      order["nodes"][i]["sequenceId"] = 2 * i;
      if (i > 0) order["edges"][i - 1]["sequenceId"] = 2 * i - 1;
    }
  }
  int last_of_base() {
    int last = static_cast<int>(rig_.sut.order().last_sequence() / 2);
    for (const Node& node : rig_.sut.order().nodes()) {
      if (node.released) last = static_cast<int>(node.sequence / 2);
    }
    return last;
  }
  /// One value gone, or another one in its place.
  void mutate(json& message) {
    const json flat = message.flatten();
    auto place = flat.begin();
    std::advance(place, below(static_cast<std::uint32_t>(flat.size())));
    const json::json_pointer at(place.key());
    const json others[] = {json(),
                           -1,
                           1e18,
                           "",
                           "\u00e4",
                           json::array(),
                           json::object(),
                           true,
                           0.5,
                           4294967296,
                           std::string(200, 'x')};
    if (below(3) == 0 && !at.empty()) {
      json& parent = message.at(at.parent_pointer());
      if (parent.is_object()) parent.erase(at.back());
      return;
    }
    message[at] = others[below(std::size(others))];
  }
  void send_order() {
    json order = next_order();
    if (below(3) == 0) {
      mutate(order);
      ++mutated;
    }
    const json before = held();
    rig_.sut.on_order(order.dump(), rig_.vehicle);
    const bool is_taken = rig_.sut.take_state_request();
    const json after = held();
    if (!is_taken) EXPECT_EQ(after, before) << order;
    taken += is_taken ? 1 : 0;
    not_taken += is_taken ? 0 : 1;
    tell(rig_.texts.identity().topic("order"), order.dump(), !is_taken);
  }
  void send_action() {
    const char* types[] = {"cancelOrder",         "startPause",   "stopPause",
                           "startCharging",       "stateRequest", "factsheetRequest",
                           "clearInstantActions", "initPosition", "initializePosition"};
    json message = json::parse(rig_.texts.instant(types[below(std::size(types))],
                                                  "i" + std::to_string(++actions_),
                                                  {{"x", below(5)}, {"y", 0}, {"theta", 0.0}}));
    if (below(4) == 0) mutate(message);
    rig_.sut.on_instant_actions(message.dump(), rig_.vehicle, rig_.now);
  }
  void change_vehicle() {
    Vehicle& vehicle = rig_.vehicle;
    switch (below(7)) {
      case 0:
        vehicle.silence_s = below(3) == 0 ? 5 : 0.1;
        break;
      case 1:
        vehicle.emergency_stop = !vehicle.emergency_stop;
        break;
      case 2:
        vehicle.driver = vehicle.driver.empty() ? "anna" : "";
        break;
      case 3:
        vehicle.charge_percent = below(101);
        vehicle.is_charging = below(2) == 0;
        break;
      case 4:
        vehicle.navigation_reason = below(4) == 0 ? "no_pose" : "";
        break;
      case 5:
        vehicle.bumper = !vehicle.bumper;
        break;
      default:
        publications_.on_connected();
    }
  }
  /// The vehicle and its mission control, as far as they are asked.
  void drive() {
    for (const Request& request : rig_.take()) {
      if (request.kind == Kind::drive) {
        poses_ = request.poses;
        at_ = 0;
        rig_.vehicle.mission = "running";
      }
      const bool is_under_way = !poses_.empty();
      if (request.kind == Kind::pause && is_under_way) rig_.vehicle.mission = "paused";
      if (request.kind == Kind::resume && is_under_way) rig_.vehicle.mission = "running";
      if (request.kind == Kind::cancel_drive) end(News::canceled, "aborted");
      const bool is_sound = request.kind == Kind::set_pose && request.poses[0].x_m < 20;
      if (is_sound) rig_.vehicle.pose = request.poses[0];
      if (request.kind == Kind::dock) {
        ++rig_.vehicle.docking_run;
        rig_.vehicle.docking = "done";
        rig_.vehicle.docking_result = below(3) == 0 ? "no_dock_found" : "docked";
      }
    }
    if (poses_.empty() || rig_.vehicle.mission != "running") return;
    if (below(40) == 0) return end(News::aborted, "aborted");
    if (below(2) == 0) return;
    rig_.vehicle.pose = poses_[at_++];
    if (at_ == poses_.size()) return end(News::succeeded, "done");
    rig_.sut.on_drive({News::at, static_cast<std::uint32_t>(at_)}, rig_.now);
  }
  void end(News kind, const char* mission) {
    rig_.vehicle.mission = mission;
    poses_.clear();
    rig_.sut.on_drive({kind, 0, "it ended"}, rig_.now);
  }

  GatewayFixture rig_;
  Publications publications_;
  std::mt19937 random_;
  std::ostream* file_;
  std::vector<geometry::Pose> poses_;
  std::size_t at_ = 0;
  int orders_ = 0;
  int actions_ = 0;
};

class RandomMessagesTest : public ::testing::TestWithParam<Version> {};
INSTANTIATE_TEST_SUITE_P(Versions, RandomMessagesTest,
                         ::testing::Values(Version::v2_1, Version::v3_0),
                         [](const auto& one) { return one.param == Version::v2_1 ? "v2" : "v3"; });

TEST_P(RandomMessagesTest, WhatIsRefusedChangesNothingAndWhatIsSentIsJson) {
  const int steps = std::atoi(environment("TOCSIN_VDA5050_STEPS", "500").c_str());
  const std::string path = environment("TOCSIN_VDA5050_FILE", "");
  std::ofstream file;
  if (!path.empty()) file.open(path, std::ios::app);
  Site site(GetParam(), 3, path.empty() ? nullptr : &file);
  for (int i = 0; i < steps; ++i) site.step();
  EXPECT_GT(site.taken, steps / 100);
  EXPECT_GT(site.not_taken, steps / 50);
  EXPECT_GT(site.sent, steps / 4);
  std::cout << site.sent << " sent, " << site.taken << " orders taken, " << site.not_taken
            << " not taken, " << site.mutated << " mutated\n";
}

}  // namespace
}  // namespace tocsin::vda5050
