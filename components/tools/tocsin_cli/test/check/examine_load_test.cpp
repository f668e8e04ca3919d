// SPDX-License-Identifier: Apache-2.0
#include "examine_load.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/temporary_folder.hpp"
#include "graphs.hpp"

namespace tocsin::check {
namespace {

using ::testing::HasSubstr;

/// A writer of ten samples of 900 bytes a second: IP packets of 1092 bytes to each other host.
class ExamineLoadTest : public ::testing::Test {
 protected:
  ExamineLoadTest() {
    folder_.write("qos.yaml",
                  "sensor: {reliability: best_effort}\n"
                  "slow: {reliability: best_effort, max_rate_hz: 5}\n");
    folder_.write("traffic.yaml",
                  "uxv:\n"
                  "  high: {while_poor: send, topics: [x, follows], adaptive: [follows]}\n"
                  "  low: {while_poor: drop, topics: [bulk]}\n"
                  "gcs: {}\n");
    rules_.emplace(Role::uxv, TrafficRules(folder_.path("traffic.yaml"), Role::uxv));
  }
  [[nodiscard]] std::vector<Finding> examine(double capacity, const std::string& topic = "x",
                                             const std::string& qos = "sensor",
                                             Scope scope = Scope::link) const {
    Port writer = writes(topic, scope, qos);
    writer.load = load_;
    Graph graph{vehicle("source", {writer}), vehicle("own", {reads(topic, scope, qos)}),
                station("sink", {reads(topic, scope, qos)}),
                station("another", {reads(topic, scope, qos)})};
    if (third_host_) graph.push_back({"spare", Role::gcs, "desk", "sink", {}});
    return examine_load(graph, QosProfiles(folder_.path("qos.yaml")), rules_,
                        {"radio.yaml", 9, capacity, 0.1});
  }
  const TemporaryFolder folder_;
  std::map<Role, TrafficRules> rules_;
  std::optional<ExpectedLoad> load_ = ExpectedLoad{10, 900};
  bool third_host_ = false;
};

TEST_F(ExamineLoadTest, WarnsOfAStreamAboveClassLowThatIsMoreThanThePoorPlaceCarries) {
  EXPECT_TRUE(examine(10'320).empty());
  const auto findings = examine(10'319);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].severity, Severity::warning);
  EXPECT_THAT(findings[0].text,
              HasSubstr("topic x: uxv/drive/source writes 10 kB/s on the radio in class high; in "
                        "its poor places (9 dB) radio.yaml carries 10 kB/s"));
}

TEST_F(ExamineLoadTest, CountsACopyForEachOtherHost) {
  third_host_ = true;
  EXPECT_TRUE(examine(20'640).empty());
  EXPECT_EQ(examine(20'639).size(), 1U);
}

TEST_F(ExamineLoadTest, DoesNotWarnOfClassLowWhichWaitsForAllOthers) {
  EXPECT_TRUE(examine(1, "bulk").empty());
}

TEST_F(ExamineLoadTest, DoesNotWarnOfAWriterThatFollowsTheBudget) {
  EXPECT_TRUE(examine(1, "follows").empty());
}

TEST_F(ExamineLoadTest, AMaximumRateBoundsWhatIsOffered) {
  EXPECT_TRUE(examine(5'160, "x", "slow").empty());
  EXPECT_EQ(examine(5'159, "x", "slow").size(), 1U);
}

TEST_F(ExamineLoadTest, JudgesOnlyWritersThatTellWhatTheyExpect) {
  load_.reset();
  EXPECT_TRUE(examine(0).empty());
}

}  // namespace
}  // namespace tocsin::check
