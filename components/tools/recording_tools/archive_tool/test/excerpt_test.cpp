// SPDX-License-Identifier: Apache-2.0
#include "excerpt.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "small_bag.hpp"

namespace tocsin::archive {
namespace {

class ExcerptTest : public ::testing::Test {
 protected:
  ExcerptTest() : bag_(folder_.path() + "/bag") {}
  Excerpt excerpt() {
    bag_.close();
    return excerpt_of(folder_.path() + "/bag/bag_0.mcap");
  }
  TemporaryFolder folder_;
  SmallBag bag_;
};

TEST_F(ExcerptTest, CountsEachTopicWithWhatIsMissing) {
  for (const std::uint32_t sequence : {1U, 2U, 5U, 6U, 9U}) {
    bag_.locate(1, sequence, sequence);
  }
  bag_.measure(-50, 3, 1);
  const Excerpt sut = excerpt();
  ASSERT_EQ(sut.topics.size(), 2U);
  EXPECT_EQ(sut.topics[0].topic, "/location");
  EXPECT_EQ(sut.topics[0].type, "geometry_msgs/msg/PoseWithCovarianceStamped");
  EXPECT_EQ(sut.topics[0].messages, 5);
  EXPECT_EQ(sut.topics[0].gaps, 4);
  EXPECT_EQ(sut.topics[0].from_ns, noon_ns + second_ns);
  EXPECT_EQ(sut.topics[0].to_ns, noon_ns + 9 * second_ns);
  EXPECT_EQ(sut.topics[1].gaps, 0);
  EXPECT_EQ(sut.from_ns, noon_ns + second_ns);
  EXPECT_EQ(sut.to_ns, noon_ns + 9 * second_ns);
}

TEST_F(ExcerptTest, AReadingKnowsWhereItWasTaken) {
  bag_.drive(3);
  topic::BatteryState::Message battery;
  battery.percentage(0.25F);
  bag_.write<topic::BatteryState>(battery, 3, 1);
  topic::TransmissionState::Message state;
  state.role("uxv");
  state.qni(70);
  bag_.write<topic::TransmissionState>(state, 3.1, 1);
  state.role("gcs");
  state.qni(10);
  bag_.write<topic::TransmissionState>(state, 3.2, 2);
  bag_.measure(-70, 3.5, 4);
  bag_.measure(-71, 6, 5);
  const auto readings = excerpt().readings;
  ASSERT_EQ(readings.size(), 5U);
  EXPECT_EQ(readings[1].time_ns, noon_ns + second_ns + second_ns / 10);
  EXPECT_EQ(readings[1].x_m, 1);
  EXPECT_EQ(readings[1].signal_dbm, -51);
  EXPECT_EQ(readings[1].loss_percent, 5);
  EXPECT_TRUE(std::isnan(readings[1].battery_percent));
  EXPECT_EQ(readings[3].battery_percent, 25);
  EXPECT_EQ(readings[3].qni, 70) << "of the vehicle";
  EXPECT_EQ(readings[3].x_m, 2);
  EXPECT_TRUE(std::isnan(readings[4].x_m)) << "its place is too old";
}

TEST_F(ExcerptTest, AnEmptyBagHasNothing) {
  const Excerpt sut = excerpt();
  EXPECT_TRUE(sut.topics.empty());
  EXPECT_EQ(sut.from_ns, 0);
}

TEST_F(ExcerptTest, NamesWhatIsDamaged) {
  bag_.drive(100);
  bag_.close();
  const std::string path = folder_.path() + "/bag/bag_0.mcap";
  damage(path);
  try {
    (void)excerpt_of(path);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("tocsin bag recover"));
  }
}

}  // namespace
}  // namespace tocsin::archive
