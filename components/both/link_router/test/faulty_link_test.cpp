// SPDX-License-Identifier: Apache-2.0
// Two routers over a link with random faults.
#include "faulty_link.hpp"

#include <gtest/gtest.h>

namespace tocsin::router {
namespace {

TEST(FaultyLink, EveryStreamIsDeliveredAgainWithinTwoSecondsAfterTheLastFault) {
  std::size_t deliveries = 0;
  std::size_t forged = 0;
  for (unsigned seed = 1; seed <= 400; ++seed) {
    FaultyLink link(seed);
    EXPECT_EQ(link.run(), "") << "seed " << seed;
    deliveries += link.deliveries();
    forged += link.forged();
  }
  EXPECT_GT(deliveries, 10'000U);
  EXPECT_GT(forged, 400U);
}

}  // namespace
}  // namespace tocsin::router
