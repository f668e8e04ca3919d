// SPDX-License-Identifier: Apache-2.0
// Services between processes, by real UDP on loopback. Other makers' requests: test/interop.
#include <gtest/gtest.h>

#include "fast_dds/bus_fixture.hpp"
#include "fast_dds/lamp_service.hpp"
#include "ros_idl/std_srvs.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/host_graph.hpp"

namespace tocsin {
namespace {

using Response = std_srvs::srv::SetBool_Response;

int next_domain() {
  static int last = 112;
  return ++last;
}

const char* const qos = "state: {}\nevent: {reliability: reliable, depth: 100}\n";

ServiceEndpoint lamp(const std::string& node) { return lamp_endpoint("lamp/set", node); }

/// Under the names that most tests want.
struct Servant : LampServer {
  explicit Servant(Bus& bus) : LampServer(bus, lamp("lamp")) {}
};
struct Asker : LampClient {
  explicit Asker(Bus& bus) : LampClient(bus, lamp("asker")) {}
  explicit Asker(HostGraph& graph) : LampClient(graph, lamp("")) {}
};

bool success_of(const ServiceReply& reply) {
  return std::static_pointer_cast<const Response>(reply.message)->success();
}

class ServiceEndsTest : public ::testing::Test {
 protected:
  const int domain_ = next_domain();
};

TEST_F(ServiceEndsTest, EachOfTwoClientsGetsItsOwnReplies) {
  const auto server_bus = make_test_bus(domain_, qos);
  const auto client_bus = make_test_bus(domain_, qos);
  Servant servant(*server_bus);
  Asker one(*client_bus);
  Asker other(*client_bus);
  ASSERT_TRUE(eventually([&] { return one.available() && other.available(); }));
  const auto first = one.ask(true);
  const auto second = other.ask(false);
  ASSERT_TRUE(first && second);
  int answered = 0;
  ASSERT_TRUE(eventually([&] {
    answered += servant.answer();
    return !one.replies().empty() && !other.replies().empty();
  }));
  EXPECT_EQ(answered, 2);
  ASSERT_EQ(one.replies().size(), 1U);
  EXPECT_EQ(one.replies()[0].number, *first);
  EXPECT_TRUE(success_of(one.replies()[0]));
  ASSERT_EQ(other.replies().size(), 1U);
  EXPECT_EQ(other.replies()[0].number, *second);
  EXPECT_FALSE(success_of(other.replies()[0]));
}

TEST_F(ServiceEndsTest, AComponentMayCallANeighbourInItsProcess) {
  const auto bus = make_test_bus(domain_, qos);
  Servant servant(*bus);
  Asker asker(*bus);
  ASSERT_TRUE(eventually([&] { return asker.available(); }));
  ASSERT_TRUE(asker.ask(true));
  EXPECT_TRUE(eventually([&] {
    (void)servant.answer();
    return asker.replies().size() == 1;
  }));
  EXPECT_EQ(bus->host_control().callers().services, std::vector<std::string>{"lamp/set"});
}

TEST_F(ServiceEndsTest, WithoutServerNothingIsSent) {
  const auto bus = make_test_bus(domain_, qos);
  Asker asker(*bus);
  EXPECT_FALSE(asker.available());
  EXPECT_FALSE(asker.ask(true));
}

TEST_F(ServiceEndsTest, AServerThatLeavesIsNotAvailable) {
  const auto server_bus = make_test_bus(domain_, qos);
  const auto client_bus = make_test_bus(domain_, qos);
  auto servant = std::make_unique<Servant>(*server_bus);
  Asker asker(*client_bus);
  ASSERT_TRUE(eventually([&] { return asker.available(); }));
  servant.reset();
  EXPECT_TRUE(eventually([&] { return !asker.available(); }));
}

TEST_F(ServiceEndsTest, AToolIsACallerButNoParticipantOfRos2) {
  const auto bus = make_test_bus(domain_, qos);
  Servant servant(*bus);
  BusOptions options;
  options.name = "tool";
  options.host_domain = domain_;
  const auto graph = make_host_graph(options);
  EXPECT_TRUE(bus->host_control().callers().services.empty());
  Asker asker(*graph);
  ASSERT_TRUE(eventually(
      [&] { return !bus->host_control().callers().services.empty() && asker.available(); }));
  EXPECT_EQ(bus->host_control().callers().services, std::vector<std::string>{"lamp/set"});
  EXPECT_FALSE(bus->host_control().callers().ros2);
  ASSERT_TRUE(asker.ask(true));
  EXPECT_TRUE(eventually([&] {
    (void)servant.answer();
    return asker.replies().size() == 1;
  }));
}

TEST_F(ServiceEndsTest, ACallerIsNoticedAtOnce) {
  const auto bus = make_test_bus(domain_, qos);
  std::atomic<int> noticed{0};
  bus->host_control().watch_callers([&] { ++noticed; });
  const auto client_bus = make_test_bus(domain_, qos);
  const Asker asker(*client_bus);
  EXPECT_TRUE(
      eventually([&] { return noticed > 0 && !bus->host_control().callers().services.empty(); }));
  bus->host_control().watch_callers({});
}

TEST_F(ServiceEndsTest, TheEndsOfAServiceBelongToTheirNodes) {
  const auto bus = make_test_bus(domain_, qos);
  BusOptions options;
  options.name = "tool";
  options.host_domain = domain_;
  const auto graph = make_host_graph(options);
  Servant servant(*bus);
  bus->host_control().update_graph();
  ASSERT_TRUE(eventually([&] { return graph->nodes().size() == 1; }));
  const GraphNode node = graph->nodes().front();
  EXPECT_EQ(node.path(), "/lamp");
  EXPECT_EQ(node.readers.size(), 1U);
  EXPECT_EQ(node.writers.size(), 1U);
}

}  // namespace
}  // namespace tocsin
