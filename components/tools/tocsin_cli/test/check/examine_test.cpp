// SPDX-License-Identifier: Apache-2.0
#include "examine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/temporary_folder.hpp"
#include "graphs.hpp"

namespace tocsin::check {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ExamineTest : public ::testing::Test {
 protected:
  /// What is found, notes left out; as "error: text".
  [[nodiscard]] std::vector<std::string> found(const Graph& graph, bool notes = false) const {
    const QosProfiles qos(folder_.write("qos.yaml", qos_));
    const std::map<Role, TrafficRules> traffic{
        {Role::uxv, TrafficRules(folder_.write("traffic.yaml", traffic_), Role::uxv)}};
    std::vector<std::string> texts;
    for (const Finding& finding : examine(graph, {qos, traffic, topics_, has_far_end_})) {
      if (finding.severity == Severity::note && !notes) continue;
      const bool error = finding.severity == Severity::error;
      texts.push_back((error ? "error: " : "warning: ") + finding.text);
    }
    return texts;
  }

  std::string qos_ =
      "sensor: {reliability: best_effort}\nstate: {durability: transient_local, deadline_s: 1}\n";
  std::string traffic_ = "uxv: {high: {while_poor: send, topics: [location]}}\n";
  std::vector<std::string> topics_;  ///< known
  bool has_far_end_ = false;
  TemporaryFolder folder_;
};

TEST_F(ExamineTest, SaysNothingOfAPairThatFits) {
  EXPECT_THAT(found({vehicle("driver", {writes("odom")}), vehicle("navigator", {reads("odom")})}),
              IsEmpty());
}

TEST_F(ExamineTest, WarnsOfEveryReaderWithoutAWriterInOneLine) {
  EXPECT_THAT(found({vehicle("navigator", {reads("odom"), reads("goal")})}),
              ElementsAre("warning: uxv/drive/navigator: nobody writes what it reads: odom, goal"));
}

TEST_F(ExamineTest, WhatCrossesTheLinkMayBeWrittenByAHostOfAnotherFile) {
  const Graph graph{station("map_server", {reads("location", Scope::link), reads("odom")})};
  EXPECT_THAT(
      found(graph),
      ElementsAre("warning: gcs/desk/map_server: nobody writes what it reads: location, odom"));
  has_far_end_ = true;
  EXPECT_THAT(found(graph),
              ElementsAre("warning: gcs/desk/map_server: nobody writes what it reads: odom"));
}

TEST_F(ExamineTest, NotesAReaderThatDoesWithoutAWriter) {
  const Graph graph{vehicle("mux", {may_read("set_inputs"), may_read("cmd_vel/teleop")}),
                    station("recorder", {may_read("set_inputs")})};
  EXPECT_THAT(found(graph), IsEmpty());
  EXPECT_THAT(found(graph, true),
              Contains("warning: uxv/drive/mux: nobody writes what it would read as well: "
                       "set_inputs, cmd_vel/teleop"));
}

TEST_F(ExamineTest, RefusesOwnersOfATopicThatCrossesTheLink) {
  qos_ += "owned: {ownership: exclusive}\n";
  EXPECT_THAT(found({vehicle("a", {writes("location", Scope::link, "owned")}),
                     station("b", {reads("location", Scope::link, "owned")})}),
              ElementsAre("error: topic location: crosses the link; ownership: exclusive is for "
                          "host topics"));
  EXPECT_THAT(found({vehicle("a", {writes("odom", Scope::host, "owned")}),
                     vehicle("b", {reads("odom", Scope::host, "owned")})}),
              IsEmpty());
}

TEST_F(ExamineTest, NotesAWriterWithoutAReader) {
  const Graph graph{vehicle("driver", {writes("odom")})};
  EXPECT_THAT(found(graph), IsEmpty());
  EXPECT_THAT(found(graph, true), Contains(HasSubstr("nobody reads what it writes: odom")));
}

TEST_F(ExamineTest, WarnsOfAVelocityThatNobodyFollows) {
  EXPECT_THAT(found({vehicle("brake", {writes("cmd_vel/checked")})}),
              ElementsAre("warning: uxv/drive/brake: nobody follows its velocity cmd_vel/checked: "
                          "set velocity_smoother.checked to true"));
  EXPECT_THAT(found({vehicle("brake", {writes("cmd_vel/checked")}),
                     vehicle("smoother", {reads("cmd_vel/checked")})}),
              IsEmpty());
}

TEST_F(ExamineTest, AHostTopicDoesNotReachTheOtherHost) {
  EXPECT_THAT(found({vehicle("driver", {writes("odom")}), station("view", {reads("odom")})}),
              ElementsAre(AllOf(HasSubstr("uxv/drive/driver writes it, gcs/desk/view reads it on "
                                          "another host, and its scope is host")),
                          HasSubstr("gcs/desk/view: nobody writes what it reads: odom")));
}

TEST_F(ExamineTest, FindsTwoTypesOfOneTopic) {
  EXPECT_THAT(found({vehicle("driver", {writes("odom", Scope::host, "sensor", "Odometry")}),
                     vehicle("navigator", {reads("odom", Scope::host, "sensor", "Pose")})}),
              ElementsAre("error: topic odom: uxv/drive/driver writes it with type Odometry, "
                          "uxv/drive/navigator reads it with type Pose"));
}

TEST_F(ExamineTest, FindsAComponentThatDisagreesWithItself) {
  EXPECT_THAT(found({vehicle("a", {writes("status", Scope::host, "sensor", "Text"),
                                   writes("status", Scope::host, "sensor", "Flag")})}),
              ElementsAre("error: topic status: uxv/drive/a writes it with type Text, "
                          "uxv/drive/a writes it with type Flag"));
}

TEST_F(ExamineTest, FindsTwoScopesOfOneTopic) {
  EXPECT_THAT(found({vehicle("a", {writes("location", Scope::link)}),
                     vehicle("b", {reads("location", Scope::host)})}),
              ElementsAre(HasSubstr("with scope link, uxv/drive/b reads it with scope host")));
}

TEST_F(ExamineTest, NamesEveryPolicyByWhichAPairWillNotMatch) {
  EXPECT_THAT(
      found({vehicle("driver", {writes("odom", Scope::host, "sensor")}),
             vehicle("navigator", {reads("odom", Scope::host, "state")})}),
      ElementsAre(AllOf(HasSubstr("error: "), HasSubstr("QoS profile sensor"),
                        HasSubstr("reliability"), HasSubstr("durability"), HasSubstr("deadline"))));
}

TEST_F(ExamineTest, FindsAMissingProfileOnce) {
  EXPECT_THAT(found({vehicle("driver", {writes("odom", Scope::host, "lidar")}),
                     vehicle("navigator", {reads("odom", Scope::host, "lidar")})}),
              ElementsAre(AllOf(HasSubstr("error: "), HasSubstr("lidar"), HasSubstr("odom"))));
}

TEST_F(ExamineTest, FindsALinkTopicWithoutATrafficClass) {
  EXPECT_THAT(found({vehicle("a", {writes("picture", Scope::link)}),
                     station("b", {reads("picture", Scope::link)})}),
              ElementsAre(AllOf(HasSubstr("error: "), HasSubstr("picture"),
                                HasSubstr("no traffic class for role uxv"))));
}

TEST_F(ExamineTest, NotesATrafficRuleForATopicThatNobodyWrites) {
  EXPECT_THAT(found({vehicle("a", {reads("location", Scope::link)})}, true),
              ElementsAre(HasSubstr("nobody writes"),
                          HasSubstr("name topics that nothing in this role writes: location")));
}

TEST_F(ExamineTest, WarnsOfATrafficRuleForAMisspeltTopic) {
  traffic_ = "uxv: {high: {while_poor: send, topics: [loaction, battery, lidar/scan]}}\n";
  topics_ = {"battery_state", "location"};
  EXPECT_THAT(found({}), ElementsAre("warning: traffic rules of role uxv: topic loaction is not "
                                     "known here; did you mean 'location'?"))
      << "what is like no topic may be a foreign program's";
}

TEST_F(ExamineTest, ATopicThatHasItsOwnRuleIsNotWhatAnotherOneMeans) {
  traffic_ = "uxv: {high: {while_poor: send, topics: [location, location2]}}\n";
  topics_ = {"location"};
  EXPECT_THAT(found({}), IsEmpty());
}

TEST_F(ExamineTest, WarnsOfAnOverrideForAnUnknownTopic) {
  qos_ += "topics: {odometry: {max_rate_hz: 5}}\n";
  EXPECT_THAT(found({}), ElementsAre(HasSubstr("QoS overrides: topic odometry is not in")));
}

}  // namespace
}  // namespace tocsin::check
