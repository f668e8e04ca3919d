// SPDX-License-Identifier: Apache-2.0
// Services and parameters of the host, called by clients.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/ros_names.hpp"
#include "ros_idl/std_srvs.hpp"
#include "runtime/middleware/ros_parameters.hpp"
#include "runtime/middleware/ros_services.hpp"
#include "runtime/service_port.hpp"
#include "served.hpp"
#include "tocsin_idl/actions.hpp"

namespace tocsin {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using namespace std::string_literals;

struct Dock {
  using Request = std_srvs::srv::SetBool_Request;
  using Response = std_srvs::srv::SetBool_Response;
  static constexpr const char* name = "dock";
};

struct SendMission {
  using Request = nav2_msgs::action::FollowWaypoints_SendGoal_Request;
  using Response = nav2_msgs::action::FollowWaypoints_SendGoal_Response;
  static constexpr const char* name = "follow_waypoints/_action/send_goal";
};

struct Events {
  using Message = rcl_interfaces::msg::ParameterEvent;
  static constexpr TopicInfo info{"/parameter_events", "event", Scope::host};
};

/// A node with a service and one parameter, `speed`.
class Node final : public Component {
 public:
  explicit Node(Context& context) : Component(context) {}
  void tick(Time /*now*/) override {
    while (auto call = dock_.take()) {
      Dock::Response response;
      response.success(call->request->data());
      response.message("docked");
      dock_.reply(call->id, response);
    }
    while (auto call = missions_.take()) {
      missions.push_back(*call->request);
      missions_.reply(call->id, {});
    }
    while (auto call = list_.take()) {
      parameter_service::ListParameters::Response response;
      response.result().names({"speed"});
      list_.reply(call->id, response);
    }
    while (auto call = get_.take()) {
      parameter_service::GetParameters::Response response;
      for (std::size_t i = 0; i < call->request->names().size(); ++i) {
        response.values().push_back(ros_value(speed));
      }
      get_.reply(call->id, response);
    }
    while (auto call = set_.take()) {
      parameter_service::SetParameters::Response response;
      for (const auto& one : call->request->parameters()) {
        rcl_interfaces::msg::SetParametersResult result;
        result.successful(one.value().double_value() <= 1);
        if (result.successful()) speed = one.value().double_value();
        if (!result.successful()) result.reason("is outside [0, 1]");
        response.results().push_back(result);
      }
      set_.reply(call->id, response);
    }
  }
  double speed = 0.5;
  std::vector<SendMission::Request> missions;

 private:
  Server<Dock> dock_{*this};
  Server<SendMission> missions_{*this};
  Server<parameter_service::ListParameters> list_{*this};
  Server<parameter_service::GetParameters> get_{*this};
  Server<parameter_service::SetParameters> set_{*this};
};

constexpr const char* mission_service = "/follow_waypoints/_action/send_goal";

foxglove::HostPicture picture() {
  foxglove::HostPicture made = foxglove::stated_picture("");
  made.services = {
      {"/dock", "std_srvs/srv/SetBool", &type_info<Dock::Request>(), &type_info<Dock::Response>()},
      {mission_service, "nav2_msgs/action/FollowWaypoints_SendGoal",
       &type_info<SendMission::Request>(), &type_info<SendMission::Response>()}};
  return made;
}

class CallsTest : public ::testing::Test {
 protected:
  CallsTest() {
    served_.bus.add(node_);
    tocsin_msgs::msg::ContainerState state;
    tocsin_msgs::msg::ComponentState component;
    component.name("navigator");
    state.components({component});
    served_.bus.publish<topic::ContainerState>(state);
    client_ = served_.client();
    EXPECT_TRUE(served_.until([this] { return client_->service("/dock").has_value(); }));
  }
  void call(const std::string& encoding, const std::string& payload,
            const std::string& service = "/dock", std::uint32_t number = 77) {
    client_->say_bytes("\x02" + bytes_of(client_->service(service).value_or(0)) + bytes_of(number) +
                       bytes_of(static_cast<std::uint32_t>(encoding.size())) + encoding + payload);
  }
  /// The reason why a call of a mission fails; empty: it was answered.
  std::string refusal_of_mission(const std::string& encoding, const std::string& payload) {
    const std::size_t failures = client_->heard("serviceCallFailure").size();
    const std::size_t answers = client_->frames(3).size();
    call(encoding, payload, mission_service);
    EXPECT_TRUE(served_.until([&] {
      return client_->heard("serviceCallFailure").size() + client_->frames(3).size() >
             failures + answers;
    }));
    const auto all = client_->heard("serviceCallFailure");
    return all.size() == failures ? "" : all.back().at("message").get<std::string>();
  }
  [[nodiscard]] json values(const std::string& id) const {
    for (const json& message : client_->heard("parameterValues")) {
      if (message.value("id", "") == id) return message.at("parameters");
    }
    return nullptr;
  }
  Served served_{{}, picture};
  Context context_{served_.bus, "navigator", Role::gcs};
  Node node_{context_};
  std::unique_ptr<SocketClient> client_;
};

TEST_F(CallsTest, AServiceIsCalledInJson) {
  call("json", R"({"data": true})");
  ASSERT_TRUE(served_.until([&] { return !client_->frames(3).empty(); }));
  const std::string bytes = client_->frames(3).front().bytes;
  EXPECT_EQ(bytes.substr(4, 12), bytes_of(77) + bytes_of(4) + "json");
  EXPECT_EQ(json::parse(bytes.substr(16)),
            json::parse(R"({"success": true, "message": "docked"})"));
}

TEST_F(CallsTest, AServiceIsCalledInCdr) {
  call("cdr", "\x00\x01\x00\x00\x01"s);
  ASSERT_TRUE(served_.until([&] { return !client_->frames(3).empty(); }));
  EXPECT_EQ(client_->frames(3).front().bytes.substr(15),
            "\x00\x01\x00\x00\x01\x00\x00\x00\x07\x00\x00\x00"
            "docked\x00"s);
}

TEST_F(CallsTest, ALyingClientsMissionsAreRefusedEachWithItsReason) {
  const std::pair<const char*, const char*> lies[] = {
      {"{", "is not a JSON object"},
      {R"({"goal": {"poses": 3}})", "goal.poses: must be a list"},
      {R"({"goal": {"poses": [{"pose": {"position": {"x": "far"}}}]}})", "must be a number"},
      {R"({"goal": {"number_of_loops": -1}})", "goal.number_of_loops: must be a whole number"},
      {R"({"goal": {"goal_index": 4294967296}})", "goal.goal_index: must be a whole number"},
      {R"({"goal_id": {"uuid": [256]}})", "must be a whole number"},
      {R"({"mission": []})", "there is no field 'mission'"},
  };
  for (const auto& [payload, reason] : lies) {
    EXPECT_THAT(refusal_of_mission("json", payload), HasSubstr(reason)) << payload;
  }
  // Of four billion poses in 28 bytes.
  const std::string header = "\x00\x01\x00\x00"s;
  EXPECT_THAT(refusal_of_mission("cdr", header + std::string(20, '\0') + "\xff\xff\xff\xff"s),
              HasSubstr("are not the CDR"));
  EXPECT_THAT(refusal_of_mission("xml", "<poses/>"), HasSubstr("encoding 'xml'"));
  EXPECT_TRUE(node_.missions.empty());
  EXPECT_EQ(refusal_of_mission("json", R"({"goal": {"poses": [{}, {}]}})"), "");
  ASSERT_EQ(node_.missions.size(), 1U);
  EXPECT_EQ(node_.missions[0].goal().poses().size(), 2U);
}

TEST_F(CallsTest, AMissionIsRefusedWhileAnotherDrivesByHand) {
  served_.settle(*client_);
  tocsin_msgs::msg::DriverState state;
  state.driver("anna");
  served_.bus.publish<topic::DriverState>(state);
  served_.bus.run_for(std::chrono::milliseconds(1));
  EXPECT_THAT(refusal_of_mission("json", "{}"), HasSubstr("anna drives by hand"));
  client_->say({{"op", "advertise"},
                {"channels",
                 {{{"id", 5},
                   {"topic", "/teleop/request"},
                   {"encoding", "json"},
                   {"schemaName", "tocsin_msgs/msg/DriverRequest"}}}}});
  client_->say_bytes("\x01" + bytes_of(5) + R"({"name": "anna", "verb": "keep"})");
  served_.settle(*client_);
  EXPECT_EQ(refusal_of_mission("json", "{}"), "") << "she herself may send one";
  EXPECT_EQ(node_.missions.size(), 1U);
}

TEST_F(CallsTest, AServiceThatNobodyServesFailsAtItsDeadline) {
  foxglove::HostPicture dead = picture();
  dead.services.front().name = "/nobody";
  OperatorServerComponent::Params params;
  params.service_timeout_s = 0.2;
  Served served(params, [dead] { return dead; });
  const auto client = served.client();
  ASSERT_TRUE(served.until([&] { return client->service("/nobody").has_value(); }));
  client->say_bytes("\x02" + bytes_of(client->service("/nobody").value_or(0)) + bytes_of(1) +
                    bytes_of(4) + "json{}");
  EXPECT_TRUE(served.until([&] { return !client->heard("serviceCallFailure").empty(); }));
}

TEST_F(CallsTest, AllParametersOfAllNodesAreRead) {
  client_->say({{"op", "getParameters"}, {"parameterNames", json::array()}, {"id", "all"}});
  ASSERT_TRUE(served_.until([&] { return !values("all").is_null(); }));
  EXPECT_EQ(values("all"),
            json::parse(R"([{"name": "/navigator.speed", "value": 0.5, "type": "float64"}])"));
}

TEST_F(CallsTest, AParameterIsSetAndShownAsItIs) {
  client_->say({{"op", "setParameters"},
                {"parameters", {{{"name", "/navigator.speed"}, {"value", 0.25}}}},
                {"id", "set"}});
  ASSERT_TRUE(served_.until([&] { return !values("set").is_null(); }));
  EXPECT_EQ(values("set").at(0).at("value"), 0.25);
  EXPECT_EQ(node_.speed, 0.25);
  client_->say({{"op", "setParameters"},
                {"parameters", {{{"name", "/navigator.speed"}, {"value", 7}}}},
                {"id", "refused"}});
  ASSERT_TRUE(served_.until([&] { return !values("refused").is_null(); }));
  EXPECT_EQ(values("refused").at(0).at("value"), 0.25);
  EXPECT_TRUE(client_->was_told("/navigator.speed: is outside [0, 1]"));
}

TEST_F(CallsTest, ParametersOfNoNodeAreAnsweredAtOnce) {
  client_->say({{"op", "getParameters"}, {"parameterNames", {"/nobody.x", "x"}}, {"id", "none"}});
  ASSERT_TRUE(served_.until([&] { return !values("none").is_null(); }));
  EXPECT_EQ(values("none"), json::array());
  EXPECT_TRUE(client_->was_told("there is no node with '/nobody.x'"));
}

TEST_F(CallsTest, AChangeIsToldToWhoHearsTheParameter) {
  client_->say({{"op", "subscribeParameterUpdates"}, {"parameterNames", {"/navigator.speed"}}});
  served_.settle(*client_);
  rcl_interfaces::msg::ParameterEvent event;
  event.node("/navigator");
  rcl_interfaces::msg::Parameter one;
  one.name("speed");
  one.value(ros_value(0.75));
  event.changed_parameters({one});
  served_.bus.publish<Events>(event);
  ASSERT_TRUE(served_.until([&] { return !values("").is_null(); }));
  EXPECT_EQ(values("").at(0).at("value"), 0.75);
}

}  // namespace
}  // namespace tocsin
