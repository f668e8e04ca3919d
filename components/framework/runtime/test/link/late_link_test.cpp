// SPDX-License-Identifier: Apache-2.0
// An interface of the link that comes up after the router was made. Real Fast DDS on a veth pair in
// network namespaces of the test's own.
#include "foundation/network_interface.hpp"
#include "link/namespace_pair.hpp"

namespace tocsin {
namespace {

/// `left` with 10.9.0.1 is up, but without carrier, because `right` with 10.9.0.2 is down.
class LateLinkTest : public NamespacePair {
 protected:
  void SetUp() override {
    NamespacePair::SetUp();
    if (IsSkipped()) return;
    ASSERT_TRUE(plug());
  }
  [[nodiscard]] bool plug() const { return NamespacePair::plug("10.9.0"); }
  static BusOptions left() { return options_of("10.9.0.1", "10.9.0.2"); }
  static BusOptions right() { return options_of("10.9.0.2", "10.9.0.1"); }
  [[nodiscard]] std::unique_ptr<Relay> right_router() const {
    return NamespacePair::right_router(right());
  }
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
  const auto writer = process->advertise(low_topic);
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
  const auto writer = process->advertise(low_topic);
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
  const auto writer = process->advertise(low_topic);
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
