// SPDX-License-Identifier: Apache-2.0
// Ends whose QoS does not fit, as long as they are there. Real Fast DDS on loopback; each test has
// a domain of its own.
#include <gtest/gtest.h>

#include "fast_dds/bus_fixture.hpp"
#include "ros_idl/std_msgs.hpp"

namespace tocsin {
namespace {

const Endpoint text{{"text", "sensor", Scope::host}, &type_info<std_msgs::msg::String>()};

class QosMisfitTest : public ::testing::Test {
 protected:
  static int domain() {
    static int next = 60;
    return ++next;
  }
};

TEST_F(QosMisfitTest, AnIncompatibleEndIsNamedAtBothEndsUntilItIsGone) {
  const int one = domain();
  const auto a = make_test_bus(one, "sensor: {reliability: best_effort}\n");
  auto b = make_test_bus(one, "sensor: {reliability: reliable}\n");
  Samples samples;
  auto writer = a->advertise(text);
  auto reader = b->subscribe(text, samples);
  const std::string whose = "reliability (test)";
  ASSERT_TRUE(eventually([&] { return health_of(*a, "text", true).misfit == whose; }));
  ASSERT_TRUE(eventually([&] { return health_of(*b, "text", false).misfit == whose; }));
  reader.reset();
  EXPECT_TRUE(eventually([&] { return health_of(*a, "text", true).misfit.empty(); }));
  reader = b->subscribe(text, samples);
  ASSERT_TRUE(eventually([&] { return health_of(*a, "text", true).misfit == whose; }));
  reader.reset();
  b.reset();  // its whole process leaves
  EXPECT_TRUE(eventually([&] { return health_of(*a, "text", true).misfit.empty(); }));
  EXPECT_GE(health_of(*a, "text", true).incompatible_qos, 1U) << "the history stays";
}

TEST_F(QosMisfitTest, EveryPolicyOfAContractIsHeardAsItIsAnnounced) {
  const int one = domain();
  const auto a = make_test_bus(one, "sensor: {deadline_s: 0.3, liveliness_lease_s: 3.7}\n");
  const auto b = make_test_bus(one,
                               "sensor: {durability: transient_local, deadline_s: 0.2, liveliness: "
                               "manual_by_topic, liveliness_lease_s: 1.1, ownership: exclusive}\n");
  const auto c = make_test_bus(one, "sensor: {deadline_s: 0.3, liveliness_lease_s: 3.7}\n");
  Samples samples;
  const auto writer = a->advertise(text);
  const auto same = c->subscribe(text, samples);
  ASSERT_TRUE(eventually([&] { return health_of(*a, "text", true).matched == 1; }));
  EXPECT_EQ(health_of(*a, "text", true).misfit, "");
  const auto other = b->subscribe(text, samples);
  EXPECT_TRUE(eventually([&] {
    return health_of(*a, "text", true).misfit ==
           "durability, deadline, liveliness, ownership (test)";
  })) << health_of(*a, "text", true).misfit;
}

}  // namespace
}  // namespace tocsin
