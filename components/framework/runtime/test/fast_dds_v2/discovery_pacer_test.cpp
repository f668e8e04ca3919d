// SPDX-License-Identifier: Apache-2.0
#include "fast_dds_v2/discovery_pacer.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace tocsin {
namespace {

namespace rtps = eprosima::fastdds::rtps;
using std::chrono::milliseconds;

const Time t0{std::chrono::hours(1)};
constexpr StateKey heartbeat{0x07, 1};
constexpr StateKey acknowledgement{0x06, 1};

DiscoveryPacer::Held message(std::uint8_t number, std::uint32_t port = 1) {
  DiscoveryPacer::Held held{{number}, {}};
  held.to.port = port;
  return held;
}

TEST(DiscoveryPacer, TheFirstGoesAtOnceAndTheNextWhenItsPeriodIsOver) {
  for (const StateKey& key : {heartbeat, acknowledgement}) {
    const Duration period = key == heartbeat ? DiscoveryPacer::heartbeat_period
                                             : DiscoveryPacer::acknowledgement_period;
    DiscoveryPacer sut;
    EXPECT_TRUE(sut.passes(key, message(1), t0));
    EXPECT_EQ(sut.deadline(), never);
    EXPECT_FALSE(sut.passes(key, message(2), t0 + period - Duration(1)));
    EXPECT_EQ(sut.deadline(), t0 + period);
    EXPECT_FALSE(sut.take_due(t0 + period - Duration(1)));
    ASSERT_TRUE(sut.take_due(t0 + period));
    EXPECT_FALSE(sut.passes(key, message(3), t0 + 2 * period - Duration(1)));
    EXPECT_TRUE(sut.take_due(t0 + 2 * period));
    EXPECT_TRUE(sut.passes(key, message(4), t0 + 3 * period));
  }
}

TEST(DiscoveryPacer, OfThoseThatAreHeldOnlyTheNewestIsSent) {
  DiscoveryPacer sut;
  EXPECT_TRUE(sut.passes(heartbeat, message(1), t0));
  EXPECT_FALSE(sut.passes(heartbeat, message(2), t0));
  EXPECT_FALSE(sut.passes(heartbeat, message(3), t0));
  const auto due = sut.take_due(t0 + DiscoveryPacer::heartbeat_period);
  ASSERT_TRUE(due);
  EXPECT_EQ(due->message, std::vector<std::uint8_t>{3});
  EXPECT_FALSE(sut.take_due(t0 + milliseconds(100)));
}

TEST(DiscoveryPacer, ANewerOneThatPassesTakesTheHeldOnesPlace) {
  DiscoveryPacer sut;
  EXPECT_TRUE(sut.passes(heartbeat, message(1), t0));
  EXPECT_FALSE(sut.passes(heartbeat, message(2), t0));
  EXPECT_TRUE(sut.passes(heartbeat, message(3), t0 + milliseconds(100)));
  EXPECT_FALSE(sut.take_due(t0 + milliseconds(200)));
}

TEST(DiscoveryPacer, EndpointsAndDestinationsDoNotWaitForEachOther) {
  DiscoveryPacer sut;
  EXPECT_TRUE(sut.passes(heartbeat, message(1), t0));
  EXPECT_TRUE(sut.passes(acknowledgement, message(1), t0));
  EXPECT_TRUE(sut.passes(StateKey{0x07, 2}, message(1), t0));
  EXPECT_TRUE(sut.passes(heartbeat, message(1, 2), t0));
}

TEST(DiscoveryPacer, ManyLivesOfPeersLoseNothingThatIsHeld) {
  DiscoveryPacer sut;
  EXPECT_TRUE(sut.passes(heartbeat, message(1), t0));
  EXPECT_FALSE(sut.passes(heartbeat, message(2), t0));
  for (std::uint8_t i = 2; i < 200; ++i) {
    EXPECT_TRUE(sut.passes(StateKey{0x07, i}, message(i), t0));
  }
  EXPECT_TRUE(sut.take_due(t0 + milliseconds(100)));
}

}  // namespace
}  // namespace tocsin
