// SPDX-License-Identifier: Apache-2.0
#include "examine_load.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/temporary_folder.hpp"
#include "graphs.hpp"

namespace tocsin::check {
namespace {

using ::testing::HasSubstr;

/// A writer of ten samples of 900 bytes a second: IP packets of 1060 bytes to one reader, 1044 to
/// each of two.
class ExamineLoadTest : public ::testing::Test {
 protected:
  ExamineLoadTest() {
    folder_.write("qos.yaml",
                  "flow_controllers: {radio: {max_bytes_per_period: 400, period_s: 0.1},\n"
                  "                   free: {max_bytes_per_period: 0}}\n"
                  "state: {reliability: reliable}\n"
                  "sensor: {reliability: best_effort}\n"
                  "bound: {reliability: reliable, flow_controller: radio}\n"
                  "free: {reliability: reliable, flow_controller: free}\n"
                  "slow: {reliability: reliable, max_rate_hz: 5}\n");
  }
  [[nodiscard]] std::vector<Finding> examine(double capacity, const std::string& qos = "state",
                                             Scope scope = Scope::link) const {
    Port writer = writes("x", scope, qos);
    writer.load = ExpectedLoad{10, 900};
    Node second = station("plotter", {reads("x", scope, qos)});
    second.container = "other";
    Graph graph{vehicle("source", {writer}), vehicle("own", {reads("x", scope, qos)}),
                station("sink", {reads("x", scope, qos)}),
                station("sink of the same process", {reads("x", scope, qos)})};
    if (two_readers_) graph.push_back(second);
    const QosProfiles profiles(folder_.path("qos.yaml"));
    return examine_load(graph, profiles, {"radio.yaml", 9, capacity, 0.1});
  }
  const TemporaryFolder folder_;
  bool two_readers_ = false;
};

TEST_F(ExamineLoadTest, WarnsOfAReliableStreamThatIsMoreThanThePoorPlaceCarries) {
  EXPECT_TRUE(examine(10'600).empty());
  const auto findings = examine(10'599);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].severity, Severity::warning);
  EXPECT_THAT(
      findings[0].text,
      HasSubstr("topic x: uxv/drive/source writes it reliably (QoS profile state), 11 kB/s "
                "on the radio to 1 process; in its poor places (9 dB) radio.yaml carries "));
}

TEST_F(ExamineLoadTest, CountsACopyForEachReadingProcessOnTheOtherHost) {
  two_readers_ = true;
  EXPECT_TRUE(examine(20'880).empty());
  EXPECT_EQ(examine(20'879).size(), 1U);
}

TEST_F(ExamineLoadTest, DoesNotWarnOfBestEffort) { EXPECT_TRUE(examine(1, "sensor").empty()); }

TEST_F(ExamineLoadTest, DoesNotWarnOfWhatStaysOnItsHost) {
  EXPECT_TRUE(examine(1, "state", Scope::host).empty());
}

TEST_F(ExamineLoadTest, LeavesAMissingProfileToOthers) { EXPECT_TRUE(examine(1, "none").empty()); }

TEST_F(ExamineLoadTest, AFlowControllerBoundsWhatIsOffered) {
  EXPECT_TRUE(examine(4'000, "bound").empty());
  EXPECT_EQ(examine(3'999, "bound").size(), 1U);
  EXPECT_EQ(examine(10'599, "free").size(), 1U);
}

TEST_F(ExamineLoadTest, AMaximumRateBoundsWhatIsOffered) {
  EXPECT_TRUE(examine(5'300, "slow").empty());
  EXPECT_EQ(examine(5'299, "slow").size(), 1U);
}

TEST_F(ExamineLoadTest, JudgesOnlyWritersThatTellWhatTheyExpect) {
  const Graph graph{vehicle("source", {writes("x", Scope::link, "state")}),
                    station("sink", {reads("x", Scope::link, "state")})};
  EXPECT_TRUE(
      examine_load(graph, QosProfiles(folder_.path("qos.yaml")), {"radio.yaml", 9, 0, 1}).empty());
}

}  // namespace
}  // namespace tocsin::check
