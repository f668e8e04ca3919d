// SPDX-License-Identifier: Apache-2.0
// An interface of the link that comes up after the bus was made. Real Fast DDS on a veth pair in a
// network namespaces of the test's own.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>

#include <algorithm>
#include <cstdlib>

#include "fast_dds/bus_fixture.hpp"
#include "fast_dds/late_interface.hpp"
#include "ros_idl/std_msgs.hpp"

namespace tocsin {
namespace {

using String = std_msgs::msg::String;

const char* const qos =
    "state: {reliability: reliable, durability: transient_local, depth: 1}\n"
    "sensor: {reliability: reliable, depth: 5}\n";
const Endpoint state{{"state", "state", Scope::link}, &type_info<String>()};
const Endpoint low{{"low", "sensor", Scope::link}, &type_info<String>()};
const char* const traffic =
    "uxv: {critical: {while_poor: send, topics: [state]}, low: {while_poor: drop, topics: "
    "[low]}}\n";

bool run(const std::string& command) {
  return std::system(("ip " + command + " 2>/dev/null").c_str()) == 0;
}

std::shared_ptr<const String> message(const std::string& data) {
  auto made = std::make_shared<String>();
  made->data(data);
  return made;
}

std::string text_of(const Sample& sample) {
  return std::static_pointer_cast<const String>(sample.message)->data();
}

/// A bus whose link is on `address`.
std::unique_ptr<Bus> make_link_bus(const std::string& address, const std::string& peer) {
  const std::string path = ::testing::TempDir() + "late_link_test_" + std::to_string(getpid());
  std::ofstream(path + "_qos.yaml") << qos;
  std::ofstream(path + "_traffic.yaml") << traffic;
  BusOptions options;
  options.name = "bus_" + address;
  options.role = "uxv";
  options.qos_file = path + "_qos.yaml";
  options.traffic_file = path + "_traffic.yaml";
  options.host_domain = address.back() - '0';  // not one host: they meet on the link only
  options.link_domain = 20;
  options.link_address = address;
  options.link_peers = {peer};
  options.processes = 40;  // one process makes many participants here
  auto bus = make_fast_dds_bus(options);
  unlink(options.qos_file.c_str());
  unlink(options.traffic_file.c_str());
  return bus;
}

int own_namespace() { return open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC); }

/// Two network namespaces joined by a veth pair: `left` with 10.9.0.1 is up, but without carrier,
/// because `right` with 10.9.0.2 in the other one is down.
class LateLinkTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { deliver_by_packets(); }
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
  [[nodiscard]] static std::unique_ptr<Bus> make_left() {
    return make_link_bus("10.9.0.1", "10.9.0.2");
  }
  [[nodiscard]] std::unique_ptr<Bus> make_right() const {
    return on_right([] { return make_link_bus("10.9.0.2", "10.9.0.1"); });
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

TEST_F(LateLinkTest, LinkTopicsJoinWhenTheInterfaceGetsItsCarrierAndTheLastStateCrosses) {
  const auto left = make_left();
  const auto right = make_right();
  Samples states;
  Samples lows;
  const auto state_reader = right->subscribe(state, states);
  const auto low_reader = right->subscribe(low, lows);
  const auto state_writer = left->advertise(state);
  const auto low_writer = left->advertise(low);
  EXPECT_EQ(state_writer->write(message("old")), Status::paused);
  EXPECT_EQ(state_writer->write(message("newest")), Status::paused);
  EXPECT_EQ(low_writer->write(message("dropped")), Status::paused);
  ASSERT_TRUE(give_carrier());
  ASSERT_TRUE(states.wait_for(1));
  ASSERT_TRUE(eventually([&] {
    (void)low_writer->write(message("live"));
    return !lows.all().empty();
  }));
  EXPECT_EQ(text_of(states.all().front()), "newest");
  EXPECT_EQ(text_of(lows.all().front()), "live");
}

TEST_F(LateLinkTest, WhileItWaitsTheHealthOfItsTopicsSaysSo) {
  const auto bus = make_left();
  const auto writer = bus->advertise(state);
  const auto waits = [&] {
    const auto all = bus->health();
    return std::any_of(all.begin(), all.end(), [](const auto& one) { return one.waits; });
  };
  EXPECT_TRUE(waits());
  EXPECT_TRUE(bus->link_traffic().front().paused);
  ASSERT_TRUE(give_carrier());
  EXPECT_TRUE(eventually([&] { return !waits(); }));
  EXPECT_FALSE(bus->link_traffic().front().paused);
}

// Unplugged and plugged in again: another interface, with the same address.
TEST_F(LateLinkTest, AnInterfaceThatIsTakenAwayAndMadeAgainCarriesTheSameTopics) {
  ASSERT_TRUE(give_carrier());
  const auto left = make_left();
  const auto right = make_right();
  Samples heard;
  const auto reader = right->subscribe(low, heard);
  const auto writer = left->advertise(low);
  const auto crosses = [&] {
    const std::size_t before = heard.all().size();
    return eventually([&] {
      (void)writer->write(message("x"));
      return heard.all().size() > before;
    });
  };
  ASSERT_TRUE(crosses());
  ASSERT_TRUE(run("link del left") && plug() && give_carrier());
  EXPECT_TRUE(crosses());
}

TEST_F(LateLinkTest, ABusWhoseInterfaceNeverComesEndsAtOnce) {
  const auto begin = std::chrono::steady_clock::now();
  make_left().reset();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

}  // namespace
}  // namespace tocsin
