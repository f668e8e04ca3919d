// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>

#include "fast_dds/bus_fixture.hpp"
#include "ros_idl/std_msgs.hpp"
#include "runtime/testing/relay.hpp"

namespace tocsin {

inline const Endpoint low_topic{{"low", "sensor", Scope::link},
                                &type_info<std_msgs::msg::String>()};

inline std::shared_ptr<const std_msgs::msg::String> text(const std::string& data) {
  auto made = std::make_shared<std_msgs::msg::String>();
  made->data(data);
  return made;
}

/// A host whose router is on `address`. They meet on the link only.
inline BusOptions options_of(const std::string& address, const std::string& peer) {
  static const std::string file = [] {
    const std::string path = ::testing::TempDir() + "namespaces_" + std::to_string(getpid());
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

/// Two network namespaces of the test's own, left and right. The test is on the left; threads stay
/// where they were started.
class NamespacePair : public ::testing::Test {
 protected:
  void SetUp() override {
    for (int* one : {&right_, &left_}) {
      if (unshare(CLONE_NEWNET) != 0) GTEST_SKIP() << "no network namespace: needs CAP_SYS_ADMIN";
      *one = own_namespace();
      if (!run("link set lo up")) GTEST_SKIP() << "no ip";
    }
  }
  void TearDown() override {
    setns(home_, CLONE_NEWNET);
    for (const int one : {left_, right_, home_}) close(one);
  }
  [[nodiscard]] static bool run(const std::string& command) {
    return std::system(("ip " + command + " 2>/dev/null").c_str()) == 0;
  }
  template <class Body>
  auto on_right(Body body) const {
    setns(right_, CLONE_NEWNET);
    auto result = body();
    setns(left_, CLONE_NEWNET);
    return result;
  }
  /// Joins them by a veth pair: `left` + name with NETWORK.1 is up, but without carrier, because
  /// `right` + name with NETWORK.2 is down.
  [[nodiscard]] bool plug(const std::string& network, const std::string& name = "") const {
    const std::string right = "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(right_);
    return run("link add left" + name + " type veth peer name right" + name) &&
           run("link set right" + name + " netns " + right) &&
           run("addr add " + network + ".1/24 dev left" + name) &&
           run("link set left" + name + " up") &&
           on_right([&] { return run("addr add " + network + ".2/24 dev right" + name); });
  }
  [[nodiscard]] bool give_carrier(const std::string& name = "") const {
    return on_right([&] { return run("link set right" + name + " up"); });
  }
  [[nodiscard]] std::unique_ptr<Relay> right_router(const BusOptions& options) const {
    return on_right([&] { return std::make_unique<Relay>(options); });
  }

 private:
  static int own_namespace() { return open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC); }
  const int home_ = own_namespace();
  int left_ = -1;
  int right_ = -1;
};

}  // namespace tocsin
