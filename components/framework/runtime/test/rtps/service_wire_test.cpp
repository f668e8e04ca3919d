// SPDX-License-Identifier: Apache-2.0
#include "rtps/service_wire.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(ServiceWire, TopicsAreNamedAsRos2NamesThem) {
  EXPECT_EQ(service_topics("", "dock").request, "rq/dockRequest");
  EXPECT_EQ(service_topics("", "dock").reply, "rr/dockReply");
  EXPECT_EQ(service_topics("uxv", "arm/dock").request, "rq/uxv/arm/dockRequest");
  EXPECT_EQ(service_topics("uxv", "/dock").reply, "rr/dockReply");
}

// rmw_cyclonedds writes guid and sequence number as 64 bits each, then the message.
TEST(ServiceWire, AHeaderStandsBetweenEncapsulationAndMessage) {
  const Bytes message{0, 1, 0, 0, 1};
  const CycloneHeader header{0x1122334455667788, 5};
  const Bytes headed{0,    1, 0, 0, 0x88, 0x77, 0x66, 0x55, 0x44, 0x33, 0x22,
                     0x11, 5, 0, 0, 0,    0,    0,    0,    0,    1};
  EXPECT_EQ(with_header(message, header), headed);
  const auto taken = take_header(headed);
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->header.client, header.client);
  EXPECT_EQ(taken->header.number, header.number);
  EXPECT_EQ(taken->bytes, message);
}

TEST(ServiceWire, AHeaderHasTheByteOrderOfItsMessage) {
  const Bytes headed{0,    0,    0, 0, 0x11, 0x22, 0x33, 0x44, 0x55, 0x66,
                     0x77, 0x88, 0, 0, 0,    0,    0,    0,    0,    5};
  const auto taken = take_header(headed);
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->header.client, 0x1122334455667788U);
  EXPECT_EQ(taken->header.number, 5);
  EXPECT_EQ(taken->bytes, (Bytes{0, 0, 0, 0}));
  EXPECT_EQ(with_header(taken->bytes, taken->header), headed);
}

TEST(ServiceWire, ANumberMayBeAnyOf64Bits) {
  const auto taken = take_header(with_header({0, 1, 0, 0}, {~std::uint64_t{0}, -2}));
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->header.client, ~std::uint64_t{0});
  EXPECT_EQ(taken->header.number, -2);
}

TEST(ServiceWire, FewerBytesThanAHeaderAreNoRequest) {
  EXPECT_FALSE(take_header(Bytes(19, 0)));
  EXPECT_TRUE(take_header(Bytes(20, 0)));
}

TEST(ServiceWire, TheMakerTellsHowRequestsAndRepliesBelongTogether) {
  const Gid fast{1, 0x0F};
  const Gid cyclone{1, 0x10};
  EXPECT_EQ(correlation_of(fast, "typehash=RIHS01_ab;"), Correlation::identity);
  EXPECT_EQ(correlation_of(cyclone, ""), Correlation::header);
  EXPECT_EQ(correlation_of(fast, "clientid=1.2;"), Correlation::header);
  EXPECT_EQ(correlation_of(fast, "serviceid=1.2;typehash=x;"), Correlation::header);
}

}  // namespace
}  // namespace tocsin
