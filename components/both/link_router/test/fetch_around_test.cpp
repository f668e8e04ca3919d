// SPDX-License-Identifier: Apache-2.0
// What of a log crosses by itself.
#include <gmock/gmock.h>

#include "backfill_fixture.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class FetchAroundTest : public HistoryLinkTest {
 protected:
  /// Fetches so much before and after an emergency stop.
  void fetch_around_stops(int s) {
    const std::string time = std::to_string(s);
    start_with(
        "uxv:\n  low: {topics: [cpu_load], log: [odom]}\n"
        "  fetch:\n    - {when: safety_status, field: emergency_stop, topics: ['*'],\n"
        "       before_s: " +
        time + ", after_s: " + time + "}\n");
    begin_odom();
  }
  /// After a kill.
  void next_instance() {
    start();
    begin_odom();
  }
  void begin_odom() {
    meet_station();
    (void)begin("odom");
  }
  void stop(bool stands = true) {
    tocsin_msgs::msg::SafetyStatus status;
    status.emergency_stop(stands);
    host_->bus.publish<topic::SafetyStatus>(status);
  }
};

TEST_F(FetchAroundTest, WhatIsAroundAnEmergencyStopCrossesByItself) {
  fetch_around_stops(2);
  write(1);
  run(10);
  write(2);
  run(1);
  for (int i = 0; i < 5; ++i) {
    stop();
    run(0.2);
  }
  write(3);
  run(5);
  write(4);
  run(5);
  EXPECT_THAT(sent(), ElementsAre(2, 3));
  stop(false);
  run(5);
  EXPECT_THAT(sent(), ElementsAre(2, 3)) << "nothing follows from its end";
}

TEST_F(FetchAroundTest, WhatIsWantedOutlivesTheRouterAndCrossesOnce) {
  // Large ones, so that they take several batches.
  fetch_around_stops(4);
  run(10);
  stop();
  for (std::uint64_t sequence = 1; sequence <= 20; ++sequence) write(sequence, host_flow, 900);
  next_instance();
  stop();
  run(20);  // its clock begins with it
  ASSERT_GE(sent().size(), 5U) << "the event before the kill";
  const std::uint64_t confirmed = batches().at(1)->samples().back().sequence_number();
  confirm(1, 2);
  run(1);
  next_instance();
  run(20);
  ASSERT_FALSE(sent().empty());
  EXPECT_EQ(sent().front(), confirmed + 1) << "what was confirmed does not cross again";
  for (std::uint32_t number = 1; number <= 20; ++number) {
    confirm(1, number);
    run(1);
  }
  EXPECT_EQ(sent().back(), 20U);
  EXPECT_EQ(state().fetches().at(0).state(), "done");
  next_instance();
  run(20);
  EXPECT_THAT(sent(), IsEmpty());
  EXPECT_THAT(state().fetches(), IsEmpty()) << "what is done is not looked for again";
}

TEST_F(FetchAroundTest, AStopThatGoesOnOverARestartIsOneEvent) {
  fetch_around_stops(8);
  run(2);
  stop();
  run(1);
  next_instance();
  for (int i = 0; i < 20; ++i) {
    stop();
    run(0.2);
  }
  EXPECT_EQ(state().fetches().size(), 1U);
}

TEST_F(FetchAroundTest, ARuleOfTheTrafficFileFetchesItsTopicsAroundWhatItNames) {
  start_with(
      "uxv:\n  low: {topics: [cpu_load], log: [camera, odom]}\n"
      "  fetch:\n    - {when: battery_state, field: percentage, below: 0.2,\n"
      "       topics: ['od*'], before_s: 3, after_s: 0}\n");
  meet_station();
  (void)begin("odom");
  (void)begin("camera", camera_flow);
  write(1);
  run(10);
  write(2);
  write(3, camera_flow);
  run(1);
  sensor_msgs::msg::BatteryState battery;
  battery.percentage(0.3F);
  host_->bus.publish<topic::BatteryState>(battery);
  run(5);
  EXPECT_THAT(sent(), IsEmpty());
  write(4);
  run(1);
  battery.percentage(0.1F);
  host_->bus.publish<topic::BatteryState>(battery);
  run(5);
  EXPECT_THAT(sent(), ElementsAre(4)) << "of odom the last 3 s, and no picture";
}

}  // namespace
}  // namespace tocsin
