// SPDX-License-Identifier: Apache-2.0
// An interface of the link that comes up after the router was made. Real Fast DDS on a veth pair in
// network namespaces of the test's own.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>

#include <cstdlib>

#include "fast_dds/bus_fixture.hpp"
#include "foundation/network_interface.hpp"
#include "ros_idl/std_msgs.hpp"
#include "runtime/testing/relay.hpp"

namespace tocsin {
namespace {

using String = std_msgs::msg::String;

const Endpoint low{{"low", "sensor", Scope::link}, &type_info<String>()};

bool run(const std::string& command) {
  return std::system(("ip " + command + " 2>/dev/null").c_str()) == 0;
}

std::shared_ptr<const String> text(const std::string& data) {
  auto made = std::make_shared<String>();
  made->data(data);
  return made;
}

/// A host whose router is on `address`. They meet on the link only.
BusOptions options_of(const std::string& address, const std::string& peer) {
  static const std::string file = [] {
    const std::string path = ::testing::TempDir() + "late_link_" + std::to_string(getpid());
    std::ofstream(path) << "uxv: {low: {while_poor: drop, topics: [low]}}\n"
                           "gcs: {low: {while_poor: drop, topics: [low]}}\n";
    return path;
  }();
  BusOptions options;
  options.name = options.host = "host_" + address;
  options.role = Role::uxv;
  options.traffic_file = file;
  options.qos_file = std::string(TOCSIN_REPOSITORY) + "/config/qos.yaml";
  options.host_domain = address.back() - '0';
  options.link_domain = 20;
  options.link_address = address;
  options.link_peers = {peer};
  return options;
}

int own_namespace() { return open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC); }

/// Two network namespaces joined by a veth pair: `left` with 10.9.0.1 is up, but without carrier,
/// because `right` with 10.9.0.2 in the other one is down.
class LateLinkTest : public ::testing::Test {
 protected:
  void SetUp() override {
    for (int* one : {&right_, &left_}) {
      if (unshare(CLONE_NEWNET) != 0) GTEST_SKIP() << "no network namespace: needs CAP_SYS_ADMIN";
      *one = own_namespace();
      if (!run("link set lo up")) GTEST_SKIP() << "no ip";
    }
    ASSERT_TRUE(plug());
  }
  void TearDown() override {
    setns(home_, CLONE_NEWNET);
    for (const int one : {left_, right_, home_}) close(one);
  }
  /// The rest of the test is on the left; threads stay where they were started.
  template <class Body>
  auto on_right(Body body) const {
    setns(right_, CLONE_NEWNET);
    auto result = body();
    setns(left_, CLONE_NEWNET);
    return result;
  }
  /// Makes the pair, called on the left.
  [[nodiscard]] bool plug() const {
    const std::string right = "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(right_);
    return run("link add left type veth peer name right") && run("link set right netns " + right) &&
           run("addr add 10.9.0.1/24 dev left") && run("link set left up") &&
           on_right([] { return run("addr add 10.9.0.2/24 dev right"); });
  }
  [[nodiscard]] bool give_carrier() const {
    return on_right([] { return run("link set right up"); });
  }
  static BusOptions left() { return options_of("10.9.0.1", "10.9.0.2"); }
  static BusOptions right() { return options_of("10.9.0.2", "10.9.0.1"); }
  [[nodiscard]] std::unique_ptr<Relay> right_router() const {
    return on_right([] { return std::make_unique<Relay>(right()); });
  }

 private:
  const int home_ = own_namespace();
  int left_ = -1;
  int right_ = -1;
};

TEST_F(LateLinkTest, AnInterfaceWithoutCarrierOrAddressIsNotRunning) {
  EXPECT_TRUE(interface_is_running("127.0.0.1"));
  EXPECT_FALSE(interface_is_running("10.9.0.1"));                           // up, without carrier
  EXPECT_FALSE(interface_is_running("10.9.0.3"));                           // nowhere
  EXPECT_FALSE(on_right([] { return interface_is_running("10.9.0.2"); }));  // down
  ASSERT_TRUE(give_carrier());
  EXPECT_TRUE(eventually([] { return interface_is_running("10.9.0.1"); }));
}

TEST_F(LateLinkTest, FlowsCrossOnceTheInterfaceGetsItsCarrier) {
  Relay left_router(left());
  const auto far = right_router();
  const auto process = make_fast_dds_bus(left());
  const auto writer = process->advertise(low);
  const auto crosses = [&] {
    (void)writer->write(text("x"));
    return !far->crossed().empty();
  };
  EXPECT_FALSE(crosses());
  EXPECT_TRUE(left_router.peers().empty());
  ASSERT_TRUE(give_carrier());
  EXPECT_TRUE(eventually(crosses));
}

// Unplugged and plugged in again: another interface, with the same address.
TEST_F(LateLinkTest, AnInterfaceThatIsTakenAwayAndMadeAgainCarriesTheSameFlows) {
  ASSERT_TRUE(give_carrier());
  const Relay left_router(left());
  const auto far = right_router();
  const auto process = make_fast_dds_bus(left());
  const auto writer = process->advertise(low);
  const auto crosses = [&] {
    const std::size_t before = far->crossed().size();
    return eventually([&] {
      (void)writer->write(text("x"));
      return far->crossed().size() > before;
    });
  };
  ASSERT_TRUE(crosses());
  ASSERT_TRUE(run("link del left") && plug() && give_carrier());
  EXPECT_TRUE(crosses());
}

// As when a lease of DHCP ends and comes again.
TEST_F(LateLinkTest, AnInterfaceThatLosesItsAddressAndGetsItBackCarriesTheSameFlows) {
  ASSERT_TRUE(give_carrier());
  const Relay left_router(left());
  const auto far = right_router();
  const auto process = make_fast_dds_bus(left());
  const auto writer = process->advertise(low);
  const auto crosses = [&] {
    const std::size_t before = far->crossed().size();
    (void)writer->write(text("x"));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return far->crossed().size() > before;
  };
  ASSERT_TRUE(eventually(crosses));
  ASSERT_TRUE(run("addr del 10.9.0.1/24 dev left"));
  EXPECT_TRUE(eventually([&] { return !crosses(); }));
  ASSERT_TRUE(run("addr add 10.9.0.1/24 dev left"));
  EXPECT_TRUE(eventually(crosses));
}

TEST_F(LateLinkTest, ARouterWhoseInterfaceNeverComesEndsAtOnce) {
  const auto begin = std::chrono::steady_clock::now();
  make_fast_dds_link_bus(left(), [] {}).reset();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

}  // namespace
}  // namespace tocsin
