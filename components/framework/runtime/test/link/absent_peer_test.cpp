// SPDX-License-Identifier: Apache-2.0
// A router that speaks with one of two peers: real Fast DDS over a veth pair between two network
// namespaces of the test's own.
#include <gmock/gmock.h>

#include "link/namespace_pair.hpp"

namespace tocsin {
namespace {

/// A vehicle on the left, two sites at two addresses on the right, and a writer on the left.
class AbsentPeerTest : public NamespacePair {
 protected:
  void SetUp() override {
    NamespacePair::SetUp();
    if (IsSkipped()) return;
    ASSERT_TRUE(plug("10.9.0") && give_carrier());
    ASSERT_TRUE(on_right([] { return run("addr add 10.9.0.3/24 dev right"); }));
    BusOptions own = options_of("10.9.0.1", "10.9.0.2");
    own.link_peers = {"10.9.0.2", "10.9.0.3"};
    own.sites = own.peer_names = {"host_10.9.0.2", "host_10.9.0.3"};
    vehicle_.emplace(own);
    north_ = right_router(options_of("10.9.0.2", "10.9.0.1"));
    south_ = right_router(options_of("10.9.0.3", "10.9.0.1"));
    process_ = make_fast_dds_bus(own);
    writer_ = process_->advertise(low_topic);
    ASSERT_TRUE(crosses_to(*north_) && crosses_to(*south_)) << "not discovered";
  }
  /// Whether something of what is written now comes there.
  [[nodiscard]] bool crosses_to(Relay& site) const {
    (void)site.take_crossed();
    return eventually([&] {
      (void)writer_->write(text("x"));
      return !site.crossed().empty();
    });
  }
  std::optional<Relay> vehicle_;
  std::unique_ptr<Relay> north_;
  std::unique_ptr<Relay> south_;
  std::unique_ptr<Bus> process_;
  std::unique_ptr<Publication> writer_;
};

TEST_F(AbsentPeerTest, GetsTheStopAndNothingElse) {
  vehicle_->set_absent({"host_10.9.0.2"});
  ASSERT_TRUE(eventually([&] { return vehicle_->lost_peers() == 1; }));
  ASSERT_TRUE(crosses_to(*south_)) << "so that nothing is on its way to the other";
  (void)north_->take_crossed();
  StopValue stop;
  stop.number = 7;
  vehicle_->say_stop(stop);
  EXPECT_TRUE(eventually([&] { return north_->stop_number() == 7; }));
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(crosses_to(*south_));
  EXPECT_THAT(north_->crossed(), ::testing::IsEmpty());
}

TEST_F(AbsentPeerTest, IsFoundAgainWithoutDiscovery) {
  vehicle_->set_absent({"host_10.9.0.2"});
  ASSERT_TRUE(eventually([&] { return vehicle_->lost_peers() == 1; }));
  ASSERT_TRUE(crosses_to(*south_));
  vehicle_->set_absent({"host_10.9.0.3"});
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_TRUE(crosses_to(*north_));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
  EXPECT_TRUE(eventually([&] { return vehicle_->peers().back() == "host_10.9.0.2"; }));
}

}  // namespace
}  // namespace tocsin
