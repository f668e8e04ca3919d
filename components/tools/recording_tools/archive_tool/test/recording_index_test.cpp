// SPDX-License-Identifier: Apache-2.0
// With SQLite; test/archive does the same with PostgreSQL.
#include "recording_index.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "small_bag.hpp"

namespace tocsin::archive {
namespace {

Recording recording_of(const std::string& id, const std::string& vehicle, const std::string& host) {
  Recording recording;
  recording.path = "/runs/1/" + host + "/bag/bag_0.mcap";
  recording.id = id;
  recording.bytes = 1000;
  recording.vehicle = vehicle;
  recording.host = host;
  recording.run = "1";
  return recording;
}

IndexQuery of_vehicle(const std::string& vehicle) {
  IndexQuery query;
  query.vehicle = vehicle;
  return query;
}
IndexQuery of_topic(const std::string& topic) {
  IndexQuery query;
  query.topic = topic;
  return query;
}
IndexQuery of_time(std::int64_t from_ns, std::int64_t to_ns) {
  IndexQuery query;
  query.from_ns = from_ns;
  query.to_ns = to_ns;
  return query;
}

Excerpt excerpt(std::int64_t from_ns) {
  Excerpt excerpt;
  excerpt.from_ns = from_ns;
  excerpt.to_ns = from_ns + 10 * second_ns;
  excerpt.topics = {{"/odom", "nav_msgs/msg/Odometry", 500, from_ns, excerpt.to_ns, 3},
                    {"/scan", "sensor_msgs/msg/LaserScan", 70, from_ns, excerpt.to_ns, 0}};
  Reading reading;
  reading.time_ns = from_ns + second_ns;
  reading.signal_dbm = -61;
  reading.x_m = 1.5;
  excerpt.readings = {reading};
  return excerpt;
}

class RecordingIndexTest : public ::testing::Test {
 protected:
  [[nodiscard]] RecordingIndex open() const {
    return RecordingIndex(open_database(folder_.path() + "/index.sqlite"));
  }
  TemporaryFolder folder_;
};

TEST_F(RecordingIndexTest, KnowsAfterwardsWhatWasAdded) {
  open().add(recording_of("a", "uxv1", "uxv"), excerpt(noon_ns));
  RecordingIndex sut = open();
  EXPECT_TRUE(sut.has("a"));
  EXPECT_FALSE(sut.has("b"));
  const auto files = sut.files({});
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].object, "uxv1/1/uxv_bag_0-a.mcap");
  EXPECT_EQ(files[0].from_ns, noon_ns);
  EXPECT_EQ(files[0].messages, 570);
  EXPECT_EQ(files[0].gaps, 3);
  EXPECT_EQ(files[0].bytes, 1000);
}

TEST_F(RecordingIndexTest, WhatIsAddedTwiceIsThereOnce) {
  RecordingIndex one = open();
  RecordingIndex other = open();
  one.add(recording_of("a", "uxv1", "uxv"), excerpt(noon_ns));
  other.add(recording_of("a", "uxv1", "uxv"), excerpt(noon_ns));
  EXPECT_EQ(one.files({})[0].messages, 570);
  EXPECT_EQ(one.readings({}).size(), 1U);
}

TEST_F(RecordingIndexTest, AnswersByVehicleTopicAndTime) {
  RecordingIndex sut = open();
  sut.add(recording_of("a", "uxv1", "uxv"), excerpt(noon_ns));
  sut.add(recording_of("b", "uxv2", "uxv"), excerpt(noon_ns + 100 * second_ns));
  EXPECT_EQ(sut.files({}).size(), 2U);
  EXPECT_EQ(sut.files(of_vehicle("uxv2")).size(), 1U);
  EXPECT_EQ(sut.files(of_vehicle("uxv3")).size(), 0U);
  EXPECT_EQ(sut.files(of_topic("/scan"))[0].messages, 70);
  EXPECT_EQ(sut.files(of_topic("/tf")).size(), 0U);
  EXPECT_EQ(sut.files(of_time(noon_ns + 50 * second_ns, noon_ns + 200 * second_ns)).size(), 1U);
  EXPECT_EQ(sut.files(of_time(noon_ns + 5 * second_ns, noon_ns + 6 * second_ns)).size(), 1U)
      << "one that goes on over that time";
  EXPECT_EQ(sut.readings(of_vehicle("uxv2")).at(0).time_ns, noon_ns + 101 * second_ns);
}

TEST_F(RecordingIndexTest, ASecondThatBothSidesRecordedStandsOnce) {
  RecordingIndex sut = open();
  Excerpt at_station = excerpt(noon_ns);
  at_station.readings[0].battery_percent = 80;
  at_station.readings[0].x_m = not_known;
  sut.add(recording_of("a", "uxv1", "uxv"), excerpt(noon_ns));
  sut.add(recording_of("b", "uxv1", "gcs"), at_station);
  const auto readings = sut.readings({});
  ASSERT_EQ(readings.size(), 1U);
  EXPECT_EQ(readings[0].x_m, 1.5);
  EXPECT_EQ(readings[0].battery_percent, 80);
  EXPECT_TRUE(std::isnan(readings[0].qni)) << "nobody told it";
}

TEST_F(RecordingIndexTest, WhatFailsOnTheWayLeavesNothing) {
  RecordingIndex sut = open();
  Excerpt twice = excerpt(noon_ns);
  twice.topics.push_back(twice.topics.front());  // breaks the key
  EXPECT_THROW(sut.add(recording_of("a", "uxv1", "uxv"), twice), EnvironmentError);
  EXPECT_FALSE(sut.has("a"));
  sut.add(recording_of("a", "uxv1", "uxv"), excerpt(noon_ns));
  EXPECT_TRUE(sut.has("a"));
}

TEST_F(RecordingIndexTest, NamesAFileThatIsNoIndex) {
  put_text(folder_.path() + "/index.sqlite", std::string(5000, 'x'));
  EXPECT_THROW((void)open(), EnvironmentError);
  EXPECT_THROW((void)open_database("/absent/index.sqlite"), EnvironmentError);
}

TEST_F(RecordingIndexTest, NamesADatabaseThatDoesNotAnswer) {
  EXPECT_THROW((void)open_database("postgresql://127.0.0.1:1/none?connect_timeout=2"),
               EnvironmentError);
}

}  // namespace
}  // namespace tocsin::archive
