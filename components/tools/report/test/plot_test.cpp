// SPDX-License-Identifier: Apache-2.0
// What is drawn of a run.
#include "report/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "toy_run.hpp"

namespace tocsin::report {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

class PlotTest : public ::testing::Test {
 protected:
  [[nodiscard]] json plot() const { return json::parse(plot_of(load_recording(run_.path()))); }
  [[nodiscard]] json lines(std::size_t panel) const { return plot()["panels"].at(panel)["lines"]; }
  ToyRun run_;
};

TEST_F(PlotTest, TimesAreSecondsSinceTheRunBegan) {
  const json sut = lines(0);
  EXPECT_EQ(sut[0]["x"], (json{0, 20, 30, 60}));
  EXPECT_EQ(sut[0]["y"], (json{90, 30, 70, nullptr})) << "what was not measured is none";
  EXPECT_EQ(sut[1]["y"], (json{0, 40}));
}

TEST_F(PlotTest, TrafficHasALineForEachClassAndAPointForEachSecond) {
  const json sut = lines(1);
  ASSERT_EQ(sut.size(), 4U) << "uxv critical and low, gcs critical and high";
  EXPECT_EQ(sut[1]["name"], "uxv low");
  EXPECT_EQ(sut[1]["x"][0], 0.5);
  EXPECT_EQ(sut[1]["y"][0], 8) << "1000 bytes in the first second are 8 kbit/s";
  EXPECT_EQ(sut[1]["x"].back(), 99.5);
}

const char* const link_head =
    "receive_s,send_s,role,capacity_bytes_per_s,backlog_s,classes,capacity_measured\n";

TEST_F(PlotTest, CapacityAndBacklogAreThoseThatEachSideRecordedOfItself) {
  run_.write("uxv/link_state.csv", std::string(link_head) +
                                       "1001,1001,uxv,125000,0.02,[],0\n1001,1001,gcs,7,7,[],0\n"
                                       "1002,1002,uxv,250000,0.3,[],1\n");
  run_.write("gcs/link_state.csv",
             std::string(link_head) + "1001,1001,uxv,9,9,[],1\n1003,1003,gcs,1000,0.001,[],0\n");
  const json sut = lines(1);
  ASSERT_EQ(sut.size(), 4U);
  EXPECT_EQ(sut[0]["name"], "uxv capacity");
  EXPECT_EQ(sut[0]["y"], (json{nullptr, 2000.0})) << "kbit/s; what was not measured is none";
  EXPECT_NEAR(sut[1]["y"][0].get<double>(), 20, 1e-3) << "ms";
  EXPECT_NEAR(sut[1]["y"][1].get<double>(), 300, 1e-3);
  EXPECT_EQ(sut[2]["y"], json::array({nullptr}));
  EXPECT_EQ(sut[3]["x"], json::array({3.0}));
}

TEST_F(PlotTest, ShadesWhenTheSecondOfTwoPathsIsInUse) {
  const std::string head =
      "receive_s,send_s,role,capacity_bytes_per_s,backlog_s,capacity_measured,second_chosen\n";
  run_.write("uxv/link_state.csv", head +
                                       "1001,1001,uxv,250000,0.02,1,0\n"
                                       "1002,1002,uxv,250000,0.02,1,1\n"
                                       "1003,1003,uxv,250000,0.02,1,0\n");
  const json sut = lines(1);
  ASSERT_EQ(sut.size(), 3U);
  EXPECT_EQ(sut[1]["name"], "uxv by its second path");
  EXPECT_EQ(sut[1]["y"], (json{0.0, 50.0, 0.0}));
  run_.write("uxv/link_state.csv", head + "1001,1001,uxv,250000,0.02,1,0\n");
  EXPECT_EQ(lines(1).size(), 2U) << "it was never in use";
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
  EXPECT_EQ(plot()["panels"][1]["range"], (json{0, 4000.0}));
  EXPECT_EQ(plot()["panels"][1]["y"], "capacity [kbit/s], to 190000");
  run_.write("uxv/link_state.csv", link_states(500'000));
  EXPECT_EQ(plot()["panels"][1]["range"], (json{0, nullptr})) << "varies little";
}

TEST_F(PlotTest, ARunWithoutRoutersHasNoSuchPanel) {
  EXPECT_EQ(plot()["panels"].size(), 2U);
  EXPECT_THAT(plot().dump(), Not(HasSubstr("backlog")));
}

TEST_F(PlotTest, PausesAreShadedAndTheLastOneEndsWithTheRun) {
  EXPECT_EQ(plot()["spans"], (json{{20, 30}, {60, 100}}));
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
  EXPECT_LT(plot_of(load_recording(run_.path())).size(), 10'000'000U);
}

}  // namespace
}  // namespace tocsin::report
