// SPDX-License-Identifier: Apache-2.0
// Whom a participant knows, in whichever order Fast DDS tells of a peer and of its identity.
#include "fast_dds/discovery_listener.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "transport/packet_filter.hpp"

namespace tocsin {
namespace {

using fast_dds::Presence;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class DiscoveryListenerTest : public ::testing::Test {
 protected:
  /// What the participants' owner is told, as "name there" or "name gone".
  std::vector<std::string> told_;
  RemoteEnds ends_{{}, [this](const RemoteEnds::Participant&, const std::string& name, bool there) {
                     told_.push_back(name + (there ? " there" : " gone"));
                   }};
  const std::shared_ptr<PacketFilter> filter_ =
      std::make_shared<PacketFilter>(rtps_filter::Limits{});
  const RemoteEnds::Participant peer_ = [] {
    RemoteEnds::Participant made;
    made.value[0] = 7;
    return made;
  }();
};

TEST_F(DiscoveryListenerTest, WithoutIdentitiesWhoIsFoundIsKnown) {
  DiscoveryListener sut(ends_, Acquaintance::at_once, filter_);
  sut.on_participant({peer_, "gcs", ""}, Presence::found);
  EXPECT_THAT(told_, ElementsAre("gcs there"));
}

TEST_F(DiscoveryListenerTest, AStrangerIsKnownOnceItIsAuthenticated) {
  DiscoveryListener sut(ends_, Acquaintance::when_authenticated, filter_);
  sut.on_participant({peer_, "gcs", ""}, Presence::found);
  EXPECT_THAT(told_, IsEmpty());
  sut.on_authentication(peer_, true);
  EXPECT_THAT(told_, ElementsAre("gcs there"));
}

TEST_F(DiscoveryListenerTest, WhoIsAuthenticatedFirstIsKnownOnceItIsFound) {
  DiscoveryListener sut(ends_, Acquaintance::when_authenticated, filter_);
  sut.on_authentication(peer_, true);
  EXPECT_THAT(told_, IsEmpty());
  sut.on_participant({peer_, "gcs", ""}, Presence::found);
  EXPECT_THAT(told_, ElementsAre("gcs there"));
}

TEST_F(DiscoveryListenerTest, AParticipantWithoutANameIsKnownToo) {
  DiscoveryListener sut(ends_, Acquaintance::when_authenticated, filter_);
  sut.on_participant({peer_, "", ""}, Presence::found);
  sut.on_authentication(peer_, true);
  EXPECT_THAT(told_, ElementsAre(" there"));
}

TEST_F(DiscoveryListenerTest, WhoIsRefusedStaysAStrangerAndMayProveItselfLater) {
  DiscoveryListener sut(ends_, Acquaintance::when_authenticated, filter_);
  sut.on_participant({peer_, "gcs", ""}, Presence::found);
  sut.on_authentication(peer_, false);
  EXPECT_THAT(told_, IsEmpty());
  sut.on_authentication(peer_, true);
  EXPECT_THAT(told_, ElementsAre("gcs there"));
}

/// Anybody can send an announcement in a peer's name.
TEST_F(DiscoveryListenerTest, AnAnnouncementThatFollowsChangesNothingOfAnAuthenticatedPeer) {
  DiscoveryListener sut(ends_, Acquaintance::when_authenticated, filter_);
  sut.on_participant({peer_, "gcs", ""}, Presence::found);
  sut.on_authentication(peer_, true);
  told_.clear();
  sut.on_participant({peer_, "impostor", ""}, Presence::changed);
  EXPECT_THAT(told_, IsEmpty());
}

TEST_F(DiscoveryListenerTest, WhoHasGoneMustProveItselfAnew) {
  DiscoveryListener sut(ends_, Acquaintance::when_authenticated, filter_);
  sut.on_authentication(peer_, true);
  sut.on_participant({peer_, "gcs", ""}, Presence::found);
  sut.on_participant({peer_, "gcs", ""}, Presence::gone);
  told_.clear();
  sut.on_participant({peer_, "gcs", ""}, Presence::found);
  EXPECT_THAT(told_, IsEmpty());
}

}  // namespace
}  // namespace tocsin
