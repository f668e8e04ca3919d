// SPDX-License-Identifier: Apache-2.0
#include "link/peer_instances.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

constexpr Duration ms = std::chrono::milliseconds(1);
constexpr PeerInstances::Id first = 1;
constexpr PeerInstances::Id second = 2;

class PeerInstancesTest : public ::testing::Test {
 protected:
  PeerInstancesTest() { EXPECT_EQ(sut.on_announced(first, "gcs", now).joined, first); }
  /// Who counts.
  [[nodiscard]] PeerInstances::Id current() const {
    return sut.counts(first) ? first : sut.counts(second) ? second : 0;
  }
  /// Ten samples a second of those.
  void receive(std::initializer_list<PeerInstances::Id> ids, Duration length) {
    for (const Time end = now + length; now < end; now += 100 * ms) {
      for (const auto id : ids) (void)sut.on_received(id, now);
    }
  }
  PeerInstances sut;
  Time now{std::chrono::hours(1)};
};

TEST_F(PeerInstancesTest, AnAnnouncementAloneChangesNothing) {
  receive({first}, 1000 * ms);
  EXPECT_FALSE(sut.on_announced(second, "gcs", now).joined);
  now += std::chrono::hours(1);
  EXPECT_EQ(current(), first);
}

TEST_F(PeerInstancesTest, ACandidateThatIsReceivedFromDoesNotDisplaceOneThatIs) {
  (void)sut.on_announced(second, "gcs", now);
  receive({first}, 100 * ms);
  receive({first, second}, 10000 * ms);
  EXPECT_EQ(current(), first);
}

TEST_F(PeerInstancesTest, ARestartTakesOverAfterFourUsualGaps) {
  receive({first}, 3000 * ms);
  (void)sut.on_announced(second, "gcs", now);
  receive({second}, 200 * ms);
  EXPECT_EQ(current(), first);
  receive({second}, 200 * ms);
  EXPECT_EQ(current(), second);
}

TEST_F(PeerInstancesTest, OneThatWasNeverReceivedFromYieldsAtOnce) {
  (void)sut.on_announced(second, "gcs", now);
  const auto change = sut.on_received(second, now);
  EXPECT_EQ(change.joined, second);
  EXPECT_EQ(change.left, first);
}

TEST_F(PeerInstancesTest, OneThatWasDisplacedAndGoesOnReturnsAndIsNotDisplacedSoEasilyAgain) {
  receive({first}, 1000 * ms);
  (void)sut.on_announced(second, "gcs", now);
  receive({second}, 1000 * ms);
  EXPECT_EQ(current(), second);
  receive({first, second}, 300 * ms);
  EXPECT_EQ(current(), second) << "what was under way";
  receive({first, second}, 100 * ms);
  EXPECT_EQ(current(), first);
  receive({second}, 1900 * ms);
  EXPECT_EQ(current(), first);
  receive({second}, 200 * ms);
  EXPECT_EQ(current(), second);
}

TEST_F(PeerInstancesTest, ADepartureEndsWhatIsNotFoundAgain) {
  receive({first}, 1000 * ms);
  const auto change = sut.on_departed(first, now);
  EXPECT_EQ(change.left, first);
  EXPECT_FALSE(change.joined);
  EXPECT_EQ(sut.on_announced(first, "gcs", now).joined, first) << "found again";
  EXPECT_EQ(sut.name_of(first), "gcs");
}

TEST_F(PeerInstancesTest, AfterADepartureACandidateThatIsReceivedFromCounts) {
  (void)sut.on_announced(second, "gcs", now);
  (void)sut.on_announced(3, "gcs", now);
  receive({first, second}, 1000 * ms);
  EXPECT_EQ(sut.on_departed(first, now).joined, second);
  EXPECT_FALSE(sut.on_departed(3, now).left);
}

TEST_F(PeerInstancesTest, OtherNamesAreOtherPeers) {
  EXPECT_EQ(sut.on_announced(second, "uxv", now).joined, second);
  EXPECT_TRUE(sut.counts(first));
  EXPECT_FALSE(sut.on_received(99, now).joined);
}

TEST_F(PeerInstancesTest, OfAnAbsentNameNoneCountsWhateverIsReceived) {
  receive({first}, 1000 * ms);
  const auto changes = sut.set_absent({"gcs", "other"});
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].left, first);
  EXPECT_FALSE(changes[0].joined);
  receive({first}, 1000 * ms);
  EXPECT_FALSE(sut.on_announced(second, "gcs", now).joined);
  receive({second}, 5000 * ms);
  EXPECT_EQ(current(), 0U);
  EXPECT_TRUE(sut.set_absent({"gcs"}).empty()) << "it is already";
}

TEST_F(PeerInstancesTest, AnAbsentNameReturnsAsItsLastInstance) {
  receive({first}, 1000 * ms);
  (void)sut.set_absent({"gcs"});
  (void)sut.on_announced(second, "gcs", now);
  const auto changes = sut.set_absent({});
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].joined, second);
  EXPECT_EQ(current(), second);
  EXPECT_TRUE(sut.on_departed(second, now).left);
}

TEST_F(PeerInstancesTest, OneThatDepartsWhileItIsAbsentDoesNotReturn) {
  (void)sut.set_absent({"gcs"});
  EXPECT_FALSE(sut.on_departed(first, now).left) << "it was lost before";
  EXPECT_TRUE(sut.set_absent({}).empty());
  EXPECT_EQ(sut.on_announced(second, "gcs", now).joined, second);
}

}  // namespace
}  // namespace tocsin
