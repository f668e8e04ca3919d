// SPDX-License-Identifier: Apache-2.0
#include "rtps/origin.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace tocsin {
namespace {

namespace rtps = eprosima::fastdds::rtps;

TEST(Origin, ComesBackFromItsIdentity) {
  const Origin origin{0x0123456789abcdefULL, 0x123456789ULL};
  const auto back = origin_in(identity_of(origin));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->source, origin.source);
  EXPECT_EQ(back->sequence, origin.sequence);
}

TEST(Origin, TellsOfWhichPieceTheSampleIs) {
  EXPECT_TRUE(origin_in(identity_of({1, 2}))->piece.is_whole());
  const SamplePiece last{47, 48};
  EXPECT_EQ(origin_in(identity_of({1, 2, last}))->piece, last);
}

TEST(Origin, TellsHowTheContentIsCompressed) {
  EXPECT_FALSE(origin_in(identity_of({1, 2, {}, {}}))->coding.is_compressed);
  for (const SampleCoding coding : {SampleCoding{true, 0}, SampleCoding{true, 254}}) {
    EXPECT_EQ(origin_in(identity_of({1, 2, {3, 9}, coding}))->coding, coding);
  }
}

TEST(Origin, IsNotSeenWhereThePieceCannotBe) {
  for (const auto& [index, count] : {std::pair{5, 5}, std::pair{0, 49}, std::pair{3, 0}}) {
    rtps::SampleIdentity identity = identity_of({1, 2, {1, 2}});
    rtps::GUID_t guid = identity.writer_guid();
    guid.entityId.value[0] = static_cast<rtps::octet>(index);
    guid.entityId.value[1] = static_cast<rtps::octet>(count);
    identity.writer_guid(guid);
    EXPECT_FALSE(origin_in(identity)) << index << " of " << count;
  }
}

TEST(Origin, IsNotSeenInTheIdentityOfAForeignRequest) {
  rtps::SampleIdentity foreign;
  EXPECT_FALSE(origin_in(foreign));
  rtps::GUID_t guid;
  guid.guidPrefix.value[0] = 1;
  guid.guidPrefix.value[11] = 15;
  foreign.writer_guid(guid);
  EXPECT_FALSE(origin_in(foreign));
}

TEST(Origin, AWriteOnItsBehalfBearsItsTime) {
  const std::int64_t sent_ns = 1'795'325'877'018'508'536;
  const auto params = on_behalf_of({1, 2}, sent_ns);
  EXPECT_NEAR(static_cast<double>(params.source_timestamp().to_ns() - sent_ns), 0, 1);
  EXPECT_TRUE(origin_in(params.related_sample_identity()));
}

TEST(Origin, SourcesOfTwoWritersDiffer) {
  rtps::GUID_t one;
  rtps::GUID_t other = one;
  other.entityId.value[2] = 1;
  EXPECT_NE(source_of(one), source_of(other));
  EXPECT_EQ(source_of(one), source_of(one));
}

TEST(Origin, TheWireIdOfAnEntityHasItsFirstByteHighest) {
  rtps::EntityId_t entity;
  entity.value[0] = 1;
  entity.value[1] = 2;
  entity.value[2] = 3;
  entity.value[3] = 4;
  EXPECT_EQ(wire_id_of(entity), 0x01020304U);
}

}  // namespace
}  // namespace tocsin
