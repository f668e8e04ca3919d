// SPDX-License-Identifier: Apache-2.0
#include "rtps_model/reader_proxy.hpp"

#include <gtest/gtest.h>

#include "sent_messages.hpp"

namespace tocsin::rtps {
namespace {

using Status = ReaderProxy::Status;
using Sequences = std::vector<Sequence>;

/// Of a reader that has acknowledged all before the first of `count` samples.
ReaderProxy with_unsent(std::size_t count, std::size_t bytes = 100) {
  ReaderProxy sut(7, 0);
  for (Sequence i = 1; i <= count; ++i) sut.add(sample_of(i, bytes), Status::unsent);
  return sut;
}

/// The same, sent and after the time of suppression.
ReaderProxy with_sent(std::size_t count) {
  ReaderProxy sut = with_unsent(count);
  for (Sequence i = 1; i <= count; ++i) (void)sut.on_sent(i, 0);
  sut.end_suppression();
  return sut;
}

Sequences absent_of(ReaderProxy& sut, const Sequences& wanted, Sequence first) {
  Sequences absent;
  (void)sut.request(wanted, first, absent);
  return absent;
}

TEST(ReaderProxy, SendsASampleOnce) {
  ReaderProxy sut = with_unsent(1);
  EXPECT_EQ(sut.next_unsent(1), std::optional<Fragment>(0));
  EXPECT_TRUE(sut.is_new(1));
  EXPECT_TRUE(sut.on_sent(1, 0));
  EXPECT_EQ(sut.next_unsent(1), std::nullopt);
  EXPECT_FALSE(sut.is_new(1));
}

TEST(ReaderProxy, SendsTheFragmentsInOrder) {
  ReaderProxy sut = with_unsent(1, 3000);
  for (const Fragment fragment : {1, 2}) {
    EXPECT_EQ(sut.next_unsent(1), std::optional<Fragment>(fragment));
    EXPECT_FALSE(sut.on_sent(1, fragment));
    EXPECT_TRUE(sut.is_new(1));
  }
  EXPECT_TRUE(sut.on_sent(1, 3));
  EXPECT_EQ(sut.next_unsent(1), std::nullopt);
}

TEST(ReaderProxy, AcknowledgedSamplesAreDone) {
  ReaderProxy sut = with_sent(3);
  sut.acknowledge_before(3);
  EXPECT_EQ(sut.low_mark(), 2U);
  EXPECT_TRUE(sut.waits());
  sut.acknowledge_before(2);  // an old one
  EXPECT_EQ(sut.low_mark(), 2U);
  sut.acknowledge_before(4);
  EXPECT_FALSE(sut.waits());
}

TEST(ReaderProxy, ARemovedSampleCountsAsAcknowledgedWhenItIsTheNext) {
  ReaderProxy sut = with_sent(3);
  sut.remove(2);
  EXPECT_EQ(sut.low_mark(), 0U);
  sut.remove(1);
  EXPECT_EQ(sut.low_mark(), 1U);
  sut.remove(9);
  EXPECT_EQ(sut.low_mark(), 1U);
}

TEST(ReaderProxy, IsToldByHeartbeatOfWhatItHasNotAcknowledged) {
  ReaderProxy sut = with_unsent(2);
  EXPECT_TRUE(sut.needs_heartbeat(1));
  (void)sut.on_sent(1, 0);
  (void)sut.on_sent(2, 0);
  sut.acknowledge_before(2);
  EXPECT_FALSE(sut.needs_heartbeat(1));  // sample 2 is underway
  sut.end_suppression();
  EXPECT_TRUE(sut.needs_heartbeat(1));
  sut.acknowledge_before(3);
  EXPECT_FALSE(sut.needs_heartbeat(1));
}

TEST(ReaderProxy, ResendsWhatIsRequested) {
  ReaderProxy sut = with_sent(3);
  Sequences absent;
  EXPECT_TRUE(sut.request({1, 3}, 1, absent));
  EXPECT_EQ(sut.next_unsent(1), std::nullopt);
  Sequences to_send;
  sut.answer(to_send);
  EXPECT_EQ(to_send, (Sequences{1, 3}));
  EXPECT_EQ(sut.next_unsent(1), std::optional<Fragment>(0));
  EXPECT_EQ(sut.next_unsent(2), std::nullopt);
  sut.answer(to_send);
  EXPECT_EQ(to_send.size(), 2U);
}

TEST(ReaderProxy, IgnoresARequestForWhatIsUnderway) {
  ReaderProxy sut = with_unsent(1);
  (void)sut.on_sent(1, 0);
  Sequences absent;
  EXPECT_FALSE(sut.request({1}, 1, absent));
  sut.end_suppression();
  EXPECT_TRUE(sut.request({1}, 1, absent));
  EXPECT_TRUE(absent.empty());
}

TEST(ReaderProxy, TellsWhatIsRequestedAndNoLongerPromised) {
  ReaderProxy sut(7, 3);  // matched late: nothing before sample 4
  EXPECT_EQ(absent_of(sut, {3, 4, 5}, 4), (Sequences{4, 5}));
  EXPECT_EQ(absent_of(sut, {4, 5}, 5), Sequences{5});  // a heartbeat tells of the first
}

TEST(ReaderProxy, ResendsFragmentsThatAreRequestedOnceAllWereSent) {
  ReaderProxy sut = with_unsent(1, 5000);
  (void)sut.on_sent(1, 1);
  EXPECT_TRUE(sut.request(1, {1}));
  EXPECT_EQ(sut.next_unsent(1), std::optional<Fragment>(2));  // not twice before all were sent
  for (const Fragment fragment : {2, 3, 4, 5}) (void)sut.on_sent(1, fragment);
  EXPECT_TRUE(sut.request(1, {2, 4}));  // though it is underway
  Sequences to_send;
  sut.answer(to_send);
  EXPECT_EQ(to_send, Sequences{1});
  EXPECT_EQ(sut.next_unsent(1), std::optional<Fragment>(2));
  EXPECT_FALSE(sut.on_sent(1, 2));
  EXPECT_EQ(sut.next_unsent(1), std::optional<Fragment>(4));
  EXPECT_TRUE(sut.on_sent(1, 4));
}

TEST(ReaderProxy, RequestsOfFragmentsAddUp) {
  ReaderProxy sut = with_unsent(1, 5000);
  for (const Fragment fragment : {1, 2, 3, 4, 5}) (void)sut.on_sent(1, fragment);
  EXPECT_TRUE(sut.request(1, {4}));
  EXPECT_TRUE(sut.request(1, {2, 99}));
  Sequences to_send;
  sut.answer(to_send);
  EXPECT_EQ(sut.next_unsent(1), std::optional<Fragment>(2));
  EXPECT_FALSE(sut.request(2, {1}));  // is not there
}

TEST(ReaderProxy, AWholeSampleIsResentWithAllItsFragments) {
  ReaderProxy sut = with_unsent(1, 2000);
  (void)sut.on_sent(1, 1);
  (void)sut.on_sent(1, 2);
  sut.end_suppression();
  Sequences absent;
  Sequences to_send;
  EXPECT_TRUE(sut.request({1}, 1, absent));
  sut.answer(to_send);
  EXPECT_FALSE(sut.on_sent(1, 1));
  EXPECT_TRUE(sut.on_sent(1, 2));
}

TEST(ReaderProxy, KnowsTheHoleBeforeItsFirstSample) {
  ReaderProxy sut(7, 3);
  sut.add(sample_of(6), Status::unsent);
  sut.add(sample_of(7), Status::unsent);
  EXPECT_EQ(sut.hole_before(6, 4), std::optional<Sequence>(4));
  EXPECT_EQ(sut.hole_before(6, 5), std::optional<Sequence>(5));
  EXPECT_EQ(sut.hole_before(6, 6), std::nullopt);
  EXPECT_EQ(sut.hole_before(7, 4), std::nullopt);
}

TEST(ReaderProxy, StartsOverWithTheWholeHistory) {
  ReaderProxy sut = with_sent(3);
  sut.acknowledge_before(4);
  const std::deque<SamplePtr> history{sample_of(2), sample_of(3)};
  sut.start_over(history);
  EXPECT_EQ(sut.low_mark(), 1U);
  Sequences absent;
  EXPECT_TRUE(sut.request({2, 3}, 2, absent));
  ReaderProxy nothing_kept = with_sent(3);
  nothing_kept.acknowledge_before(4);
  nothing_kept.start_over({});
  EXPECT_EQ(nothing_kept.low_mark(), 3U);
}

}  // namespace
}  // namespace tocsin::rtps
