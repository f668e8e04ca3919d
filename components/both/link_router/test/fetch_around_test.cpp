// SPDX-License-Identifier: Apache-2.0
// What of a log crosses by itself.
#include <gmock/gmock.h>

#include "history_fixture.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using FetchAroundTest = HistoryLinkTest;

TEST_F(FetchAroundTest, WhatIsAroundAnEmergencyStopCrossesByItself) {
  start(2);
  meet_station();
  (void)begin("odom");
  write(1);
  run(10);
  write(2);
  run(1);
  std_msgs::msg::Bool stop;
  stop.data(true);
  for (int i = 0; i < 5; ++i) {
    host_->bus.publish<topic::EmergencyStop>(stop);
    run(0.2);
  }
  write(3);
  run(5);
  write(4);
  run(5);
  EXPECT_THAT(sent(), ElementsAre(2, 3));
  stop.data(false);
  host_->bus.publish<topic::EmergencyStop>(stop);
  run(5);
  EXPECT_THAT(sent(), ElementsAre(2, 3)) << "nothing follows from its end";
}

TEST_F(FetchAroundTest, ARuleOfTheTrafficFileFetchesItsTopicsAroundWhatItNames) {
  (void)folder_.write("traffic.yaml",
                      "uxv:\n  low: {topics: [cpu_load], log: [camera, odom]}\n"
                      "  fetch:\n    - {when: battery_state, field: percentage, below: 0.2,\n"
                      "       topics: ['od*'], before_s: 3, after_s: 0}\n");
  script_.rules = TrafficRules(folder_.path("traffic.yaml"), Role::uxv);
  start();
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
