// SPDX-License-Identifier: Apache-2.0
#include "report/recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"
#include "toy_run.hpp"

namespace tocsin::report {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

TEST(LinkClass, IsNamedBySenderAndClassTheVehicleAndTheMostUrgentFirst) {
  std::map<LinkClass, int> sut;
  for (const TrafficClass one : {TrafficClass::low, TrafficClass::critical}) {
    sut[{Role::gcs, one}] = sut[{Role::uxv, one}] = 1;
  }
  std::vector<std::string> names;
  for (const auto& [link_class, unused] : sut) names.push_back(to_string(link_class));
  EXPECT_THAT(names, ElementsAre("uxv critical", "uxv low", "gcs critical", "gcs low"));
}

TEST(Recording, NamesAClassThatIsNone) {
  ToyRun run;
  run.write("traffic.yaml", "uxv:\n  urgent: {topics: [location]}\ngcs: {}\n");
  try {
    (void)load_recording(run.path());
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("'urgent' is no traffic class"));
    EXPECT_THAT(error.what(), HasSubstr("traffic.yaml:2"));
  }
}

TEST(Recording, CountsWhatCrossedTheLinkByClass) {
  ToyRun run;
  const Recording sut = load_recording(run.path());
  EXPECT_THAT(sut.arrivals.at({Role::uxv, TrafficClass::low}), SizeIs(3));
  EXPECT_THAT(sut.arrivals.at({Role::gcs, TrafficClass::high}), SizeIs(2));
  const Arrival& first = sut.arrivals.at({Role::uxv, TrafficClass::low})[0];
  EXPECT_EQ(first.topic, "camera/image");
  EXPECT_EQ(first.sent_s, 1000.0);
  EXPECT_EQ(first.received_s, 1000.5);
  EXPECT_EQ(first.bytes, 1000);
}

TEST(Recording, LeavesOutWhatTheReceivingSideWroteItself) {
  ToyRun run;
  const Recording sut = load_recording(run.path());
  ASSERT_THAT(sut.arrivals.at({Role::uxv, TrafficClass::critical}), SizeIs(1));
  EXPECT_EQ(sut.arrivals.at({Role::uxv, TrafficClass::critical})[0].writer, "2");
}

TEST(Recording, KeepsTheVehiclesDecisionsOnly) {
  ToyRun run;
  const Recording sut = load_recording(run.path());
  ASSERT_THAT(sut.decisions, SizeIs(4));
  EXPECT_TRUE(sut.decisions[0].active);
  EXPECT_FALSE(sut.decisions[1].active);
  EXPECT_EQ(sut.decisions[1].reason, "alarm");
  EXPECT_TRUE(std::isnan(sut.decisions[3].qni));
}

TEST(Recording, ReadsQualityAndMission) {
  ToyRun run;
  const Recording sut = load_recording(run.path());
  ASSERT_THAT(sut.qualities, SizeIs(2));
  EXPECT_EQ(sut.qualities[1].per_percent, 40);
  EXPECT_EQ(sut.mission.state, "done");
  EXPECT_EQ(sut.mission.goals_sent, 12);
  EXPECT_EQ(sut.mission.elapsed_s, 99.5);
}

TEST(Recording, CountsWhatWasWrittenHeldBackOrNot) {
  ToyRun run;
  run.write("uxv/messages.csv",
            "receive_s,send_s,topic,writer,sequence,bytes\n"
            "1000,1000,camera/image,0,1,1000\n1001,1001,camera/image,0,2,1000\n"
            "1000,1000,transmission_state,0,1,50\n1010,1010,transmission_state,7,1,50\n");
  const Recording sut = load_recording(run.path());
  EXPECT_EQ(sut.written.at({Role::uxv, TrafficClass::low}), 2U);
  // Rows of the table with role uxv.
  EXPECT_EQ(sut.written.at({Role::uxv, TrafficClass::critical}), 4U);
}

TEST(Recording, ARoutersStateComesFromTheOtherSideWhenItsOwnHasNone) {
  ToyRun run;
  run.write("gcs/link_state.csv",
            "receive_s,send_s,role,capacity_bytes_per_s,backlog_s,capacity_measured\n"
            "1001.5,1001,uxv,5000,0.25,1\n1003,1003,uxv,5000,0.25,0\n");
  const Recording sut = load_recording(run.path());
  ASSERT_EQ(sut.routers.size(), 1U) << "the station has no router";
  ASSERT_THAT(sut.routers.at(Role::uxv), SizeIs(2));
  EXPECT_EQ(sut.routers.at(Role::uxv)[0].time_s, 1001);
  EXPECT_EQ(sut.routers.at(Role::uxv)[0].capacity_bytes_per_s, 5000);
  EXPECT_EQ(sut.routers.at(Role::uxv)[0].backlog_s, 0.25);
  EXPECT_TRUE(std::isnan(sut.routers.at(Role::uxv)[1].capacity_bytes_per_s)) << "only assumed";
}

TEST(Recording, WhatARouterOfNoRoleToldIsNobodys) {
  ToyRun run;
  run.write("gcs/link_state.csv",
            "receive_s,send_s,role,capacity_bytes_per_s,backlog_s\n1001,1001,boat,1,1\n"
            "1002,1002,gcs,2,2\n");
  const Recording sut = load_recording(run.path());
  EXPECT_EQ(sut.routers.count(Role::uxv), 0U);
  EXPECT_THAT(sut.routers.at(Role::gcs), SizeIs(1));
}

TEST(Recording, KnowsWhereTheVehicleWas) {
  ToyRun run;
  run.write("uxv/location.csv",
            "receive_s,send_s,pose.pose.position.x,pose.pose.position.y\n1000,1000,1.5,-2\n");
  const Recording sut = load_recording(run.path());
  ASSERT_THAT(sut.path, SizeIs(1));
  EXPECT_EQ(sut.path[0].x_m, 1.5);
  EXPECT_EQ(sut.path[0].y_m, -2);
}

TEST(Recording, KeepsWhatWasFilledInApart) {
  ToyRun run;
  run.append(
      "gcs/messages.csv",
      "1150.0,1002.0,camera/image/backfilled,1,3,1000\n1150,1002,other/backfilled,1,3,1000\n");
  const Recording sut = load_recording(run.path());
  const LinkClass low{Role::uxv, TrafficClass::low};
  EXPECT_THAT(sut.arrivals.at(low), SizeIs(3));
  ASSERT_THAT(sut.backfilled, SizeIs(1));
  ASSERT_THAT(sut.backfilled.at(low), SizeIs(1));
  EXPECT_EQ(sut.backfilled.at(low)[0].topic, "camera/image");
  EXPECT_EQ(sut.backfilled.at(low)[0].sequence, 3U);
  EXPECT_EQ(sut.end_s, 1150);
}

TEST(Recording, KnowsItsFirstAndLastTime) {
  ToyRun run;
  const Recording sut = load_recording(run.path());
  EXPECT_EQ(sut.begin_s, 1000);
  EXPECT_EQ(sut.end_s, 1100);
}

TEST(Recording, ReportsWhatOneSideRecorded) {
  ToyRun run;
  run.remove("uxv");
  const Recording sut = load_recording(run.path());
  EXPECT_THAT(sut.arrivals.at({Role::uxv, TrafficClass::low}), SizeIs(3));
  EXPECT_EQ(sut.arrivals.count({Role::gcs, TrafficClass::high}), 0U);
}

TEST(Recording, RejectsAFolderWithoutARun) {
  EXPECT_THROW((void)load_recording("/no/such/run"), ConfigError);
}

TEST(Recording, RejectsARunWithoutARecording) {
  ToyRun run;
  run.remove("uxv");
  run.remove("gcs");
  try {
    (void)load_recording(run.path());
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("holds no recording"));
  }
}

}  // namespace
}  // namespace tocsin::report
