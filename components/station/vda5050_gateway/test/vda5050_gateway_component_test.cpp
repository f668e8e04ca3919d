// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

#include "foundation/error.hpp"
#include "order_texts.hpp"
#include "runtime/sim_bus.hpp"
#include "vda5050_gateway/vda5050_gateway_component.hpp"

namespace tocsin {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using vda5050::Broker;
using vda5050::OrderTexts;

/// What goes over the wire; it outlives the connection.
struct Wire {
  std::vector<vda5050::Message> sent;
  std::deque<Broker::Received> waiting;
  std::vector<std::string> subscriptions;
  vda5050::BrokerAddress address;
  bool is_connected = true;
  std::uint64_t connections = 1;
  std::string trouble = {};
};

class WireBroker final : public Broker {
 public:
  explicit WireBroker(Wire& wire) : wire_(wire) {}
  [[nodiscard]] std::uint64_t connections() const override { return wire_.connections; }
  [[nodiscard]] bool is_connected() const override { return wire_.is_connected; }
  bool publish(const vda5050::Message& message) override {
    if (wire_.is_connected) wire_.sent.push_back(message);
    return wire_.is_connected;
  }
  [[nodiscard]] std::optional<Received> take() override {
    if (wire_.waiting.empty()) return std::nullopt;
    Received oldest = wire_.waiting.front();
    wire_.waiting.pop_front();
    return oldest;
  }
  [[nodiscard]] std::string trouble() const override { return wire_.trouble; }

 private:
  Wire& wire_;
};

/// In mission_control's place.
class Leader : public Component {
 public:
  using Follow = action::FollowWaypoints;
  explicit Leader(Context& context) : Component(context) { wake_every(seconds(0.1)); }
  void tick(Time now) override {
    while (const auto asked = server.take(now)) {
      server.accept(now);
      goals.push_back(*asked);
    }
    if (at) {
      Follow::Feedback feedback;
      feedback.current_waypoint(*std::exchange(at, std::nullopt));
      server.feedback(goals.back().id, std::move(feedback));
    }
    if (std::exchange(succeeds, false)) server.succeed(goals.back().id, {}, now);
    if (!goals.empty() && server.is_canceling(goals.back().id)) {
      server.canceled(goals.back().id, {}, now);
    }
  }
  ActionServer<Follow> server{*this};
  std::vector<ActionServer<Follow>::Asked> goals;
  std::optional<std::uint32_t> at;
  bool succeeds = false;
};

class Vda5050GatewayComponentTest : public ::testing::Test {
 protected:
  Vda5050GatewayComponentTest() {
    params_.serial_number = "uxv1";
    computer_.has_spectators = true;
    bus_.add(leader_);
  }
  void start() {
    sut_ = std::make_unique<Vda5050GatewayComponent>(
        context_, params_,
        [this](const auto& address, const auto& /*will*/, std::vector<std::string> topics) {
          wire_.address = address;
          wire_.subscriptions = std::move(topics);
          return std::make_unique<WireBroker>(wire_);
        });
    bus_.add(*sut_);
    run(0.2);
    hear();
    locate(0);
    mission("idle");
    run(0.5);
  }
  void run(double s) { bus_.run_for(seconds(s)); }
  void hear(double silence_s = 0.05) {
    topic::LinkStop::Message message;
    message.silence_s(silence_s);
    bus_.publish<topic::LinkStop>(message);
  }
  void locate(double x) {
    topic::Location::Message message;
    message.pose().pose().position().x(x);
    message.pose().pose().orientation().w(1);
    message.pose().covariance()[0] = 0.01;
    bus_.publish<topic::Location>(message);
  }
  void mission(const char* state) {
    topic::MissionStatus::Message message;
    message.state(state);
    bus_.publish<topic::MissionStatus>(message);
    run(0.3);
  }
  void receive(const char* name, const std::string& text) {
    wire_.waiting.push_back({"vda5050/v3/tocsin/uxv1/" + std::string(name), text});
    run(0.5);
  }
  /// The last one of this topic.
  [[nodiscard]] json last(const std::string& name) const {
    for (auto message = wire_.sent.rbegin(); message != wire_.sent.rend(); ++message) {
      if (message->topic == "vda5050/v3/tocsin/uxv1/" + name) return json::parse(message->payload);
    }
    ADD_FAILURE() << "no " << name;
    return {};
  }
  [[nodiscard]] std::vector<double> places(std::size_t goal) const {
    std::vector<double> all;
    for (const auto& pose : leader_.goals.at(goal).goal->poses()) {
      all.push_back(pose.pose().position().x());
    }
    return all;
  }
  std::string error_of_start() {
    try {
      start();
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }

  const OrderTexts texts_;
  SimBus bus_;
  Wire wire_;
  Computer computer_;
  Context context_ = Context(bus_, "vda5050_gateway", Role::gcs).with_computer(computer_);
  Context leader_context_{bus_, "leader", Role::gcs};
  Leader leader_{leader_context_};
  Vda5050GatewayComponent::Params params_;
  std::unique_ptr<Vda5050GatewayComponent> sut_;
  SimReader<topic::MissionCommand> commands_{bus_};
  SimReader<topic::InitialPose> poses_{bus_};
  SimReader<topic::DockingCommand> docking_{bus_};
};

TEST_F(Vda5050GatewayComponentTest, AnOrderBecomesAGoalAndItsProgressAState) {
  start();
  EXPECT_THAT(wire_.subscriptions,
              ElementsAre("vda5050/v3/tocsin/uxv1/order", "vda5050/v3/tocsin/uxv1/instantActions"));
  EXPECT_EQ(last("connection")["connectionState"], "ONLINE");
  receive("order", texts_.order(4, 3).dump());
  ASSERT_EQ(leader_.goals.size(), 1u);
  EXPECT_THAT(places(0), ElementsAre(1, 2));
  EXPECT_EQ(leader_.goals[0].goal->poses()[0].header().frame_id(), "map");
  EXPECT_EQ(last("state")["nodeStates"].size(), 3u);
  leader_.at = 1;
  mission("running");
  EXPECT_EQ(last("state")["lastNodeId"], "b");
  leader_.succeeds = true;
  mission("done");
  EXPECT_EQ(last("state")["lastNodeId"], "c");
  EXPECT_EQ(last("state")["mobileRobotPosition"]["deviationRange"], 0.2);
}

TEST_F(Vda5050GatewayComponentTest, AnUpdateIsANewGoalForTheRest) {
  start();
  receive("order", texts_.order(3, 2).dump());
  mission("running");
  json update = texts_.order(3, 3, 1);
  update["orderUpdateId"] = 1;
  receive("order", update.dump());
  ASSERT_EQ(leader_.goals.size(), 2u);
  EXPECT_THAT(places(1), ElementsAre(1, 2, 3));
}

TEST_F(Vda5050GatewayComponentTest, CancelOrderCancelsTheGoal) {
  start();
  receive("order", texts_.order(3, 3).dump());
  mission("running");
  receive("instantActions", texts_.instant("cancelOrder", "i1"));
  run(0.5);
  EXPECT_EQ(last("state")["instantActionStates"][0]["actionStatus"], "FINISHED");
  EXPECT_THAT(last("state")["nodeStates"], IsEmpty());
}

TEST_F(Vda5050GatewayComponentTest, PauseDockingAndPositionReachTheVehiclesTopics) {
  start();
  receive("instantActions",
          texts_.instant("initializePosition", "i0", {{"x", 2}, {"y", 1}, {"theta", 0}}));
  const auto poses = poses_.take();
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_EQ(poses[0].header().frame_id(), "map");
  EXPECT_EQ(poses[0].pose().pose().position().x(), 2);
  EXPECT_GT(poses[0].pose().covariance()[0], 0);
  receive("instantActions", texts_.instant("startCharging", "i1"));
  EXPECT_EQ(docking_.take().at(0).data(), "start");
  topic::DockingStatus::Message docked;
  docked.run(1);
  docked.state("done");
  docked.result("docked");
  bus_.publish<topic::DockingStatus>(docked);
  run(0.3);
  receive("order", texts_.order(3, 3).dump());
  mission("running");
  receive("instantActions", texts_.instant("startPause", "i2"));
  EXPECT_EQ(commands_.take().at(0).data(), "pause");
  mission("paused");
  EXPECT_EQ(last("state")["paused"], true);
  receive("instantActions", texts_.instant("stopPause", "i3"));
  EXPECT_EQ(commands_.take().at(0).data(), "resume");
}

TEST_F(Vda5050GatewayComponentTest, ASilentVehicleIsToldWithinFourSeconds) {
  start();
  hear(0.1);
  run(2.5);
  EXPECT_EQ(last("connection")["connectionState"], "ONLINE");
  run(1.5);
  EXPECT_EQ(last("connection")["connectionState"], "CONNECTION_BROKEN");
  hear(nan);
  run(0.3);
  hear(0.1);
  run(0.3);
  EXPECT_EQ(last("connection")["connectionState"], "ONLINE");
}

TEST_F(Vda5050GatewayComponentTest, AnOrderWhileTheVehicleIsSilentIsHandedOn) {
  start();
  hear(60);
  run(0.3);
  receive("order", texts_.order(3, 3).dump());
  EXPECT_EQ(leader_.goals.size(), 1u) << "mission_control repeats it until the vehicle answers";
  EXPECT_EQ(last("state")["orderId"], "o1");
}

TEST_F(Vda5050GatewayComponentTest, WhatTheVehicleTellsIsInItsState) {
  start();
  topic::BatteryState::Message battery;
  battery.percentage(0.42F);
  battery.voltage(15.5F);
  battery.power_supply_status(
      sensor_msgs::msg::BatteryState_Constants::POWER_SUPPLY_STATUS_CHARGING);
  bus_.publish<topic::BatteryState>(battery);
  topic::SafetyStatus::Message safety;
  safety.emergency_stop(true);
  safety.stopped_by({"station"});
  safety.bumper(2);
  bus_.publish<topic::SafetyStatus>(safety);
  topic::NavigationStatus::Message navigation;
  navigation.state("driving");
  bus_.publish<topic::NavigationStatus>(navigation);
  topic::DriverState::Message driver;
  driver.driver("anna");
  bus_.publish<topic::DriverState>(driver);
  run(0.5);
  const json state = last("state");
  EXPECT_NEAR(state["powerSupply"]["stateOfCharge"].get<double>(), 42, 1e-4);
  EXPECT_EQ(state["powerSupply"]["charging"], true);
  EXPECT_EQ(state["safetyState"]["activeEmergencyStop"], "REMOTE");
  EXPECT_EQ(state["safetyState"]["fieldViolation"], true);
  EXPECT_EQ(state["driving"], true);
  EXPECT_EQ(state["operatingMode"], "INTERVENED");
}

TEST_F(Vda5050GatewayComponentTest, ABatteryWithoutAChargeIsEmpty) {
  start();
  topic::BatteryState::Message battery;
  battery.percentage(static_cast<float>(nan));
  battery.voltage(static_cast<float>(nan));
  bus_.publish<topic::BatteryState>(battery);
  run(0.3);
  receive("instantActions", texts_.instant("stateRequest", "i1"));
  EXPECT_EQ(last("state")["powerSupply"]["stateOfCharge"], 0);
  EXPECT_EQ(last("state")["powerSupply"].count("batteryVoltage"), 0u);
}

TEST_F(Vda5050GatewayComponentTest, ABrokerThatWasGoneIsToldAll) {
  start();
  wire_.is_connected = false;
  wire_.trouble = "The connection was lost.";
  wire_.sent.clear();
  run(40);
  EXPECT_THAT(wire_.sent, IsEmpty());
  wire_.is_connected = true;
  ++wire_.connections;
  hear();
  run(0.3);
  EXPECT_EQ(last("connection")["connectionState"], "ONLINE");
  EXPECT_EQ(last("state")["orderId"], "");
  EXPECT_EQ(last("factsheet")["manufacturer"], "tocsin");
}

TEST_F(Vda5050GatewayComponentTest, ItsEndIsToldAsOffline) {
  start();
  sut_.reset();
  EXPECT_EQ(last("connection")["connectionState"], "OFFLINE");
}

TEST_F(Vda5050GatewayComponentTest, InSimulatedTimeAndBeforeItsFirstTickItConnectsToNobody) {
  const Vda5050GatewayComponent looked_at(context_, params_, [](auto&&...) {
    ADD_FAILURE() << "it connects";
    return std::unique_ptr<Broker>();
  });
  computer_.has_spectators = false;
  start();
  EXPECT_THAT(wire_.subscriptions, IsEmpty());
}

TEST_F(Vda5050GatewayComponentTest, AFileThatCannotBeReadIsNamed) {
  params_.broker.ca_file = "/nowhere/ca.pem";
  EXPECT_THAT(error_of_start(), HasSubstr("ca_file: cannot read /nowhere/ca.pem"));
  params_.broker.ca_file = "";
  params_.broker.key_file = "/dev/null";
  EXPECT_THAT(error_of_start(), HasSubstr("belong together"));
}

TEST_F(Vda5050GatewayComponentTest, ANameThatIsNoLevelOfATopicIsRefused) {
  params_.serial_number = "uxv/1";
  EXPECT_THAT(error_of_start(), HasSubstr("serial_number: 'uxv/1' must be of A-Z"));
  params_.serial_number = "";
  EXPECT_THAT(error_of_start(), HasSubstr("serial_number"));
  params_.serial_number = "uxv1";
  params_.manufacturer = "a b";
  EXPECT_THAT(error_of_start(), HasSubstr("manufacturer: 'a b'"));
}

}  // namespace
}  // namespace tocsin
