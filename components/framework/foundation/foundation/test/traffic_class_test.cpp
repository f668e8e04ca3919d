// SPDX-License-Identifier: Apache-2.0
#include "foundation/traffic_class.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

TEST(TrafficClass, HasOneWordForEach) {
  for (const TrafficClass one : traffic_classes) EXPECT_EQ(traffic_class_of(to_string(one)), one);
  EXPECT_EQ(traffic_class_of("low"), TrafficClass::low);
}

TEST(TrafficClass, OtherWordsAreNone) {
  for (const char* word : {"", "none", "Low", "lower", "urgent"}) {
    EXPECT_EQ(traffic_class_of(word), std::nullopt) << word;
  }
}

TEST(DscpOfClass, DefaultsAreClassSelectors) {
  EXPECT_EQ(dscp(TrafficClass::critical), 48);
  EXPECT_EQ(dscp(TrafficClass::high), 32);
  EXPECT_EQ(dscp(TrafficClass::normal), 0);
  EXPECT_EQ(dscp(TrafficClass::low), 8);
}

TEST(DscpOfClass, IsSetClassByClass) {
  DscpOfClass sut;
  sut.set(TrafficClass::high, 34);
  EXPECT_EQ(sut.of(TrafficClass::high), 34);
  EXPECT_EQ(sut.of(TrafficClass::critical), 48);
  EXPECT_EQ(sut.of(TrafficClass::low), 8);
}

}  // namespace
}  // namespace tocsin
