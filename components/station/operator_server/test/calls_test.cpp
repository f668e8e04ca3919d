// SPDX-License-Identifier: Apache-2.0
// Services and parameters of the host, called by clients.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/ros_names.hpp"
#include "ros_idl/std_srvs.hpp"
#include "runtime/middleware/parameter_service.hpp"
#include "runtime/middleware/ros_parameters.hpp"
#include "runtime/service_port.hpp"
#include "served.hpp"

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

 private:
  Server<Dock> dock_{*this};
  Server<parameter_service::ListParameters> list_{*this};
  Server<parameter_service::GetParameters> get_{*this};
  Server<parameter_service::SetParameters> set_{*this};
};

foxglove::HostPicture picture() {
  foxglove::HostPicture made = foxglove::stated_picture("");
  made.services = {
      {"/dock", "std_srvs/srv/SetBool", &type_info<Dock::Request>(), &type_info<Dock::Response>()}};
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
  std::string call(const std::string& encoding, const std::string& payload) {
    return "\x02" + bytes_of(client_->service("/dock").value_or(0)) + bytes_of(77) +
           bytes_of(static_cast<std::uint32_t>(encoding.size())) + encoding + payload;
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
  client_->say_bytes(call("json", R"({"data": true})"));
  ASSERT_TRUE(served_.until([&] { return !client_->frames(3).empty(); }));
  const std::string bytes = client_->frames(3).front().bytes;
  EXPECT_EQ(bytes.substr(4, 12), bytes_of(77) + bytes_of(4) + "json");
  EXPECT_EQ(json::parse(bytes.substr(16)),
            json::parse(R"({"success": true, "message": "docked"})"));
}

TEST_F(CallsTest, AServiceIsCalledInCdr) {
  client_->say_bytes(call("cdr", "\x00\x01\x00\x00\x01"s));
  ASSERT_TRUE(served_.until([&] { return !client_->frames(3).empty(); }));
  EXPECT_EQ(client_->frames(3).front().bytes.substr(15),
            "\x00\x01\x00\x00\x01\x00\x00\x00\x07\x00\x00\x00"
            "docked\x00"s);
}

TEST_F(CallsTest, WhatIsNoRequestFails) {
  client_->say_bytes(call("json", R"({"date": true})"));
  ASSERT_TRUE(served_.until([&] { return !client_->heard("serviceCallFailure").empty(); }));
  const json failure = client_->heard("serviceCallFailure").front();
  EXPECT_EQ(failure.at("callId"), 77);
  EXPECT_THAT(failure.at("message").get<std::string>(), HasSubstr("no field 'date'"));
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
