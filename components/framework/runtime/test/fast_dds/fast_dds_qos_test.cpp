// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/fast_dds_qos.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

TEST(FastDdsQos, OnlyTheWriterJudgesALifespanBecauseClocksDiffer) {
  QosProfile profile;
  profile.lifespan_s = 5;
  EXPECT_EQ(writer_qos(profile).lifespan().duration, dds_duration(5));
  EXPECT_EQ(reader_qos(profile).lifespan().duration, eprosima::fastdds::dds::c_TimeInfinite);
}

TEST(DdsDuration, IsTheNearestNanosecondAndForEverBeyondWhatDdsCanSay) {
  EXPECT_EQ(dds_duration(0.29), (eprosima::fastdds::dds::Duration_t{0, 290'000'000}));
  EXPECT_EQ(dds_duration(1.9999999999), (eprosima::fastdds::dds::Duration_t{2, 0}));
  EXPECT_EQ(dds_duration(1e10), eprosima::fastdds::dds::c_TimeInfinite);
}

}  // namespace
}  // namespace tocsin
