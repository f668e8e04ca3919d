// SPDX-License-Identifier: Apache-2.0
// The component on real DDS beside other participants of its host.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

#include "idl_support/encode.hpp"
#include "ros_idl/std_srvs.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "runtime/service_port.hpp"
#include "served.hpp"

namespace tocsin {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr int domain = 118;

std::unique_ptr<Bus> join(const std::string& name) {
  BusOptions options;
  options.name = name;
  options.role = Role::gcs;
  options.host_domain = domain;
  return make_fast_dds_bus(options);
}

struct Dock {
  using Request = std_srvs::srv::SetBool_Request;
  using Response = std_srvs::srv::SetBool_Response;
  static constexpr const char* name = "dock";
};

/// What another process of the host has: a topic of each kind, and a service.
class Neighbour final : public Component {
 public:
  explicit Neighbour(Context& context) : Component(context) {}
  void tick(Time /*now*/) override {
    while (auto call = dock_.take()) {
      Dock::Response response;
      response.success(call->request->data());
      dock_.reply(call->id, response);
    }
    while (const auto goal = goals_.take()) goal_ids.push_back(goal->id());
  }
  Output<topic::MissionStatus> status{*this};
  std::vector<std::uint64_t> goal_ids;

 private:
  Server<Dock> dock_{*this};
  Input<topic::Goal> goals_{*this};
};

class RealHostTest : public ::testing::Test {
 protected:
  RealHostTest() {
    OperatorServerComponent::Params params;
    params.port = 0;
    sut_ = std::make_unique<OperatorServerComponent>(context_, params);
    tick();
    ClientFacts facts;
    facts.port = sut_->port();
    client_ = std::make_unique<SocketClient>(facts);
    EXPECT_TRUE(until([this] { return !client_->heard("serverInfo").empty(); }));
  }
  void tick() {
    for (Component* one : {static_cast<Component*>(sut_.get()), static_cast<Component*>(&near_)}) {
      one->schedule().begin_tick(bus_->now());
      one->take_changes();
      one->tick(bus_->now());
    }
  }
  [[nodiscard]] bool until(const std::function<bool()>& done) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!done()) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      tick();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
  }
  const std::unique_ptr<Bus> bus_ = join("page");
  const std::unique_ptr<Bus> other_ = join("other");
  Context context_{*bus_, "operator_server", Role::gcs};
  Context near_context_{*other_, "neighbour", Role::gcs};
  Neighbour near_{near_context_};
  std::unique_ptr<OperatorServerComponent> sut_;
  std::unique_ptr<SocketClient> client_;
};

TEST_F(RealHostTest, ShowsWhatIsWrittenOnTheDomainAndTheLastStateOfIt) {
  tocsin_msgs::msg::MissionStatus status;
  status.state("running");
  (void)near_.status.write(status);
  ASSERT_TRUE(until([&] { return client_->channel("/mission_status").has_value(); }));
  EXPECT_FALSE(client_->channel("/location")) << "nobody writes it";
  client_->say(
      {{"op", "subscribe"},
       {"subscriptions", {{{"id", 1}, {"channelId", *client_->channel("/mission_status")}}}}});
  ASSERT_TRUE(until([&] { return !client_->frames(1).empty(); }));
  const auto wanted = encode(type_info<tocsin_msgs::msg::MissionStatus>(), &status);
  EXPECT_EQ(client_->frames(1).front().bytes.substr(12), std::string(wanted.begin(), wanted.end()));
}

TEST_F(RealHostTest, WhatAClientPublishesIsHeardByOthers) {
  client_->say({{"op", "advertise"},
                {"channels",
                 {{{"id", 1},
                   {"topic", "/goal"},
                   {"encoding", "json"},
                   {"schemaName", "tocsin_msgs/msg/Goal"}}}}});
  ASSERT_TRUE(until([&] { return client_->channel("/goal").has_value(); })) << "it is written now";
  client_->say_bytes("\x01" + bytes_of(1) + R"({"id": 12})");
  ASSERT_TRUE(until([&] { return !near_.goal_ids.empty(); }));
  EXPECT_EQ(near_.goal_ids.front(), 12U);
}

TEST_F(RealHostTest, CallsAServiceOfAnotherProcess) {
  ASSERT_TRUE(until([&] { return client_->service("/dock").has_value(); }));
  client_->say_bytes("\x02" + bytes_of(*client_->service("/dock")) + bytes_of(7) + bytes_of(4) +
                     R"(json{"data": true})");
  ASSERT_TRUE(until([&] { return !client_->frames(3).empty(); }));
  EXPECT_THAT(client_->frames(3).front().bytes, HasSubstr(R"("success":true)"));
}

}  // namespace
}  // namespace tocsin
