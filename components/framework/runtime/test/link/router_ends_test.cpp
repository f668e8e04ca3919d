// SPDX-License-Identifier: Apache-2.0
// What ROS 2 on a host sees of a router there: hashes by its own rule, and whose ends they are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "fast_dds/remote_ends.hpp"
#include "graph/ros2_user_data.hpp"
#include "graph/ros_graph.hpp"
#include "link/link_bus_fixture.hpp"
#include "link/router_name.hpp"
#include "qos/config_file.hpp"
#include "runtime/middleware/host_graph.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;

/// Libraries of installed packages are loaded once for a process, by whoever asks first.
const int staged = ::setenv("AMENT_PREFIX_PATH", STRANGE_PREFIX, 1);
const std::string hash = "RIHS01_" + std::string(64, 'a');
const RawTopic strange{"rt/strange", "other_msgs::msg::dds_::Strange_", true, false};

class RouterEndsTest : public LinkBusFixture {
 protected:
  RouterEndsTest() : LinkBusFixture(next_domain()) {}
  /// The router's ends on the vehicle.
  [[nodiscard]] static std::vector<GraphEnd> ends_in(const HostGraph& graph) {
    auto ends = graph.ends();
    ends.erase(std::remove_if(ends.begin(), ends.end(),
                              [](const auto& one) { return one.participant != "uxv_router"; }),
               ends.end());
    return ends;
  }
  [[nodiscard]] static std::optional<GraphNode> node_in(const HostGraph& graph,
                                                        const std::string& name) {
    for (const GraphNode& one : graph.nodes()) {
      if (one.name == name) return one;
    }
    return std::nullopt;
  }
  /// Those that no node has.
  [[nodiscard]] static std::vector<std::string> homeless_in(const HostGraph& graph) {
    std::vector<std::string> homeless;
    const auto nodes = graph.nodes();
    for (const GraphEnd& end : ends_in(graph)) {
      const bool has = std::any_of(nodes.begin(), nodes.end(), [&](const GraphNode& node) {
        const auto& all = end.writer ? node.writers : node.readers;
        return std::find(all.begin(), all.end(), end.gid) != all.end();
      });
      if (!has && end.topic != discovery_topic) homeless.push_back(end.topic);
    }
    return homeless;
  }
  [[nodiscard]] BusOptions with_rules(Role role, const std::string& rules) {
    BusOptions made = options(role);
    file_ = std::make_unique<ConfigFile>(rules);
    made.traffic_file = file_->path();
    return made;
  }

 private:
  static int next_domain() {
    static int next = 92;
    return next += 3;
  }
  std::unique_ptr<ConfigFile> file_;
};

TEST_F(RouterEndsTest, EachHasTheHashOfItsTypeAndANode) {
  const Relay uxv(options(Role::uxv));
  const Relay gcs(options(Role::gcs));
  const auto vehicle = process(Role::uxv);
  const auto station = process(Role::gcs);
  Samples there;
  const auto up = vehicle->advertise(endpoint<topic::Location>());
  const auto down = station->advertise(endpoint<topic::MissionStatus>());
  const auto graph = make_host_graph(ordinary(Role::uxv));
  const auto has = [&](bool writer) {
    const auto ends = ends_in(*graph);
    return std::any_of(ends.begin(), ends.end(), [&](const auto& one) {
      return one.writer == writer && one.topic != discovery_topic;
    });
  };
  ASSERT_TRUE(eventually([&] { return has(true) && has(false); })) << "both ways";
  for (const GraphEnd& end : ends_in(*graph)) {
    EXPECT_EQ(ros2_type_hash(end.user_data), type_hash_in(end.user_data)) << end.topic;
    EXPECT_NE(ros2_type_hash(end.user_data), "") << end.topic;
  }
  EXPECT_TRUE(eventually([&] {
    return node_in(*graph, router_node) && homeless_in(*graph).empty();
  })) << ::testing::PrintToString(homeless_in(*graph));
}

TEST_F(RouterEndsTest, OfATypeThatNobodyHereKnowsTheHashIsThatOfItsWriter) {
  const Relay uxv(with_rules(Role::uxv, "uxv: {high: {topics: [strange]}}\n"));
  const auto graph = make_host_graph(ordinary(Role::uxv));
  QosProfile qos;
  qos.user_data = "typehash=" + hash + ";";
  const auto writing = graph->write(strange, qos);
  const auto other = make_host_graph(ordinary(Role::uxv));
  const auto reader = [&]() -> std::optional<GraphEnd> {
    for (const GraphEnd& end : ends_in(*other)) {
      if (end.topic == strange.name && !end.writer) return end;
    }
    return std::nullopt;
  };
  ASSERT_TRUE(eventually([&] { return reader().has_value(); }));
  EXPECT_EQ(ros2_type_hash(reader()->user_data), hash);
}

TEST_F(RouterEndsTest, AServiceOfANodeIsShownAsThatNodesAndAnotherAsTheRouters) {
  const auto bus = make_fast_dds_link_bus(
      with_rules(Role::uxv, "uxv: {}\ngcs: {high: {services: [lamp, arm/get_parameters]}}\n"),
      [] {});
  bus->services()->serve({"lamp", "std_srvs/srv/SetBool"});
  bus->services()->serve({"arm/get_parameters", "rcl_interfaces/srv/GetParameters"});
  bus->services()->call({"dock", "std_srvs/srv/Trigger"});
  const auto graph = make_host_graph(ordinary(Role::uxv));
  ASSERT_TRUE(eventually([&] {
    (void)bus->take();
    return node_in(*graph, "arm") && ends_in(*graph).size() >= 6;
  }));
  EXPECT_THAT(homeless_in(*graph), IsEmpty());
  for (const GraphEnd& end : ends_in(*graph)) {
    const auto node =
        node_in(*graph, end.topic.find("arm") == std::string::npos ? router_node : "arm");
    ASSERT_TRUE(node);
    EXPECT_NE(ros2_type_hash(end.user_data), "") << end.topic;
    if (end.topic == discovery_topic) continue;
    EXPECT_THAT(end.writer ? node->writers : node->readers, Contains(end.gid)) << end.topic;
  }
  bus->services()->end_serving("arm/get_parameters");
  EXPECT_TRUE(eventually([&] {
    (void)bus->take();
    return !node_in(*graph, "arm");
  }));
}

TEST_F(RouterEndsTest, AServiceOfATypeThatOnlyAnInstalledPackageKnowsHasItsHash) {
  ASSERT_EQ(staged, 0);
  const auto bus = make_fast_dds_link_bus(
      with_rules(Role::uxv, "uxv: {}\ngcs: {high: {services: [ask]}}\n"), [] {});
  bus->services()->serve({"ask", "strange_idl/srv/Ask"});
  const auto graph = make_host_graph(ordinary(Role::uxv));
  const auto hashes = [&] {
    std::set<std::string> found;
    for (const GraphEnd& end : ends_in(*graph)) {
      if (end.topic.find("ask") != std::string::npos) found.insert(ros2_type_hash(end.user_data));
    }
    return found;
  };
  ASSERT_TRUE(eventually([&] { return hashes().size() == 2; }));
  EXPECT_EQ(hashes(), (std::set<std::string>{"RIHS01_" + std::string(64, 'b'),
                                             "RIHS01_" + std::string(64, 'c')}));
}

// `ros2 param list /arm` looks for the node before it calls.
TEST_F(RouterEndsTest, ANodeOfAPeerIsInTheGraphBeforeItsServicesAreCalled) {
  const auto bus = make_fast_dds_link_bus(
      with_rules(Role::uxv, "uxv: {}\ngcs: {high: {services: ['*']}}\n"), [] {});
  const auto graph = make_host_graph(ordinary(Role::uxv));
  const auto has_arm = [&](bool wanted) {
    return eventually([&] {
      (void)bus->take();
      return node_in(*graph, "arm").has_value() == wanted;
    });
  };
  bus->services()->know({"arm/get_parameters", "arm/list_parameters", "dock"});
  EXPECT_TRUE(has_arm(true));
  EXPECT_FALSE(node_in(*graph, "dock"));
  bus->services()->know({"dock"});
  EXPECT_TRUE(has_arm(false));
}

TEST(RouterName, TellsTheHost) {
  EXPECT_EQ(host_in("uxv_link_router"), "uxv");
  EXPECT_EQ(host_in("somebody"), "somebody");
  EXPECT_EQ(host_in("_link_router"), "");
}

}  // namespace
}  // namespace tocsin
