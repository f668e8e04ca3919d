// SPDX-License-Identifier: Apache-2.0
// What is drawn: the data and the script that gnuplot gets.
#include "report/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "toy_run.hpp"

namespace tocsin::report {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class PlotTest : public ::testing::Test {
 protected:
  /// With or without gnuplot on this computer.
  void draw() {
    try {
      draw_plot(load_recording(run_.path()));
    } catch (const EnvironmentError& error) {
      EXPECT_THAT(error.what(), HasSubstr("gnuplot"));
    }
  }
  [[nodiscard]] std::string text(const std::string& name) const {
    return run_.read("plot/" + name);
  }
  ToyRun run_;
};

TEST_F(PlotTest, TimesAreSecondsSinceTheRunBegan) {
  draw();
  EXPECT_THAT(text("qni.dat"), StartsWith("0 90\n20 30\n30 70\n60 nan\n"));
  EXPECT_EQ(text("per.dat"), "0 0\n20 40\n");
}

TEST_F(PlotTest, TrafficHasABlockForEachClassAndAPointForEachSecond) {
  draw();
  const std::string traffic = text("traffic.dat");
  std::size_t blocks = 0;
  for (std::size_t at = 0; (at = traffic.find("\n\n\n", at)) != std::string::npos; ++at) ++blocks;
  EXPECT_EQ(blocks, 4U) << "uxv critical and low, gcs critical and high";
  EXPECT_THAT(traffic, AllOf(HasSubstr("\n0.5 8\n"), HasSubstr("\n99.5 0\n")))
      << "1000 bytes in the first second are 8 kbit/s";
}

const char* const link_head =
    "receive_s,send_s,role,capacity_bytes_per_s,backlog_s,classes,capacity_measured\n";

TEST_F(PlotTest, CapacityAndBacklogAreThoseThatEachSideRecordedOfItself) {
  run_.write("uxv/link_state.csv", std::string(link_head) +
                                       "1001,1001,uxv,125000,0.02,[],0\n1001,1001,gcs,7,7,[],0\n"
                                       "1002,1002,uxv,250000,0.3,[],1\n");
  run_.write("gcs/link_state.csv",
             std::string(link_head) + "1001,1001,uxv,9,9,[],1\n1003,1003,gcs,1000,0.001,[],0\n");
  draw();
  EXPECT_EQ(text("link.dat"), "1 nan 20\n2 2000 300\n\n\n3 nan 1\n\n\n")
      << "uxv, gcs; each as its own side recorded it; kbit/s and ms; what was not measured is none";
}

/// 100 s of router states of a vehicle that measures 2000 kbit/s, but `first` in the first second.
std::string link_states(int first_bytes_per_s) {
  std::string text = link_head;
  for (int second = 1; second <= 100; ++second) {
    const std::string time = std::to_string(1000 + second);
    const int capacity = second == 1 ? first_bytes_per_s : 250000;
    text += time + "," + time + ",uxv," + std::to_string(capacity) + ",0.02,[],1\n";
  }
  return text;
}

TEST_F(PlotTest, OneEarlySampleDoesNotFlattenTheCapacity) {
  run_.write("uxv/link_state.csv", link_states(23'750'000));
  draw();
  EXPECT_THAT(text("plot.gnuplot"), HasSubstr("[0:4000.000000]"));
}

TEST_F(PlotTest, ACapacityThatVariesLittleIsDrawnWhole) {
  run_.write("uxv/link_state.csv", link_states(500'000));
  draw();
  EXPECT_THAT(text("plot.gnuplot"), Not(HasSubstr(", to ")));
}

TEST_F(PlotTest, ARouterOfTheStationAloneShowsItsBacklog) {
  run_.write("gcs/link_state.csv", std::string(link_head) + "1003,1003,gcs,1000,nan,[],0\n");
  draw();
  EXPECT_EQ(text("link.dat"), "3 nan nan\n\n\n");
}

TEST_F(PlotTest, ARunWithoutRoutersHasNoSuchPanel) {
  draw();
  EXPECT_EQ(text("link.dat"), "");
  EXPECT_THAT(text("plot.gnuplot"), Not(HasSubstr("backlog")));
}

TEST_F(PlotTest, PausesAreBoxesAndTheLastOneEndsWithTheRun) {
  draw();
  EXPECT_THAT(text("plot.gnuplot"),
              AllOf(HasSubstr("from 20.000000, graph 0 to 30.000000, graph 1"),
                    HasSubstr("from 60.000000, graph 0 to 100.000000, graph 1")));
}

TEST_F(PlotTest, AMissionsNameIsTextAndNoCommand) {
  run_.append("gcs/mission_status.csv",
              "1101,1101,\"`touch made`'; system 'touch made'\",done,8,9,12,99.5\n");
  draw();
  EXPECT_FALSE(std::filesystem::exists(run_.path("plot/made")));
  EXPECT_THAT(text("plot.gnuplot"), Not(HasSubstr("`")));
}

TEST_F(PlotTest, NumbersOfAPeerMayBeAnything) {
  run_.append("gcs/mission_status.csv", "1101,1101,m,done,4294967295,4e9,0,nan\n");
  const Recording recording = load_recording(run_.path());
  EXPECT_EQ(recording.mission.waypoint, 1'000'000'000);
  EXPECT_EQ(recording.mission.waypoints, 1'000'000'000);
  EXPECT_EQ(recording.mission.goals_sent, 0);
}

TEST_F(PlotTest, AClockThatWasSetDuringTheRunIsDrawnAllTheSame) {
  run_.append("gcs/messages.csv", "1800000000,1800000000,camera/image,1,6,1000\n");
  draw();
  EXPECT_LT(text("traffic.dat").size(), 10'000'000U);
}

}  // namespace
}  // namespace tocsin::report
