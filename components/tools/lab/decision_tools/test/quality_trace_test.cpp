// SPDX-License-Identifier: Apache-2.0
#include "quality_trace.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "bag/bag_writer.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "idl_support/encode.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"
#include "trace_options.hpp"

namespace tocsin::tools {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

class QualityTraceTest : public ::testing::Test {
 protected:
  QualityTrace read(const std::string& text, const TraceOptions& options = {}) const {
    return read_quality_trace(folder.write("a.csv", text), options);
  }
  std::string error_of(const std::string& text, const TraceOptions& options = {}) const {
    try {
      (void)read(text, options);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  TemporaryFolder folder;
};

TEST_F(QualityTraceTest, ReadsPlainQualityOneRowASecond) {
  const QualityTrace sut = read("qni\n50\n60.5\n");
  EXPECT_EQ(sut.qni, (std::vector<double>{50, 60.5}));
  EXPECT_EQ(sut.time_s, (std::vector<double>{0, 1}));
  EXPECT_TRUE(sut.bad.empty());
}

TEST_F(QualityTraceTest, ReadsTimeFromTheFirstRowOn) {
  const QualityTrace sut = read("time_s,qni\r\n100,50\r\n106,60\r\n");
  EXPECT_EQ(sut.time_s, (std::vector<double>{0, 6}));
}

TEST_F(QualityTraceTest, TakesEmptyCellsAsNoMeasurement) {
  const QualityTrace sut = read("t,qni\n0,\n1,nan\n2,70\n");
  EXPECT_TRUE(std::isnan(sut.qni[0]));
  EXPECT_TRUE(std::isnan(sut.qni[1]));
  EXPECT_EQ(sut.measured(), std::vector<double>{70});
}

TEST_F(QualityTraceTest, ReadsTheTruthWhereItIsGiven) {
  EXPECT_EQ(read("n,state,qni\n0,0,80\n1,1,30\n").bad, (std::vector<bool>{false, true}));
}

TEST_F(QualityTraceTest, TheTruthIsGoodOrBadInEveryRow) {
  EXPECT_THAT(error_of("state,qni\n0,80\n2,30\n"),
              EndsWith("a.csv:3: state: '2' is not 0 (good) or 1 (bad)"));
  EXPECT_THAT(error_of("state,qni\n,80\n"),
              EndsWith("a.csv:2: state: '' is not 0 (good) or 1 (bad)"));
  EXPECT_THAT(error_of("state,qni\nbad,80\n"), EndsWith("state: 'bad' is not a number"));
}

TEST_F(QualityTraceTest, TheTruthOfAveragedRowsIsOfTheirProbesAndOfNoColumn) {
  const QualityTrace sut = read(
      "time_s,state,rssi_dbm,link_quality,link_quality_scale,ping_delay_ms\n"
      "0.1,0,-45,70,70,10\n0.6,1,-45,70,70,10\n");
  EXPECT_EQ(sut.qni, std::vector<double>{100});
  EXPECT_EQ(sut.bad, std::vector<bool>{false});
}

TEST_F(QualityTraceTest, ALinkQualityWithoutAScaleIsRefused) {
  const std::string head = "time_s,rssi_dbm,link_quality,link_quality_scale,ping_delay_ms\n";
  EXPECT_THAT(error_of(head + "0,-60,50,70,9\n1,-60,50,0,9\n"),
              EndsWith("a.csv:3: link_quality_scale: 0 must be above 0"));
  EXPECT_THAT(error_of(head + "0,-60,50,-70,9\n"), EndsWith("-70 must be above 0"));
  EXPECT_NEAR(read(head + "0,-45,,,9\n").qni[0], 100, 1e-9) << "not told is left out";
}

TEST_F(QualityTraceTest, SecondsWithoutARowAreLeftOut) {
  const QualityTrace sut = read(
      "time_s,rssi_dbm,link_quality,link_quality_scale,ping_delay_ms\n"
      "10.0,-45,70,70,9\n10.9,-99,0,70,\n14.5,-45,70,70,9\n");
  EXPECT_EQ(sut.time_s, (std::vector<double>{0, 4}));
  EXPECT_NEAR(sut.qni[0], 50, 1e-9);
}

TEST_F(QualityTraceTest, ReadsRecordedNetworkQuality) {
  const QualityTrace sut =
      read("receive_s,per_percent,signal_dbm,quality_percent\n5,0,-45,100\n6,100,-99,0\n7,50,,\n");
  EXPECT_EQ(sut.qni, (std::vector<double>{100, 0, 50}));
  EXPECT_EQ(sut.time_s.back(), 2);
}

/// Three decisions of each role and three qualities.
void write_bag(const std::string& path) {
  bag::BagWriter writer(path, {});
  const auto decisions = writer.add(bag::make_topic(
      "rt/transmission_state", type_info<tocsin_msgs::msg::TransmissionState>().name));
  const auto qualities = writer.add(
      bag::make_topic("rt/network_quality", type_info<tocsin_msgs::msg::NetworkQuality>().name));
  for (std::uint32_t i = 1; i <= 3; ++i) {
    const std::int64_t time_ns = i * std::int64_t{1'000'000'000};
    for (const char* const role : {"uxv", "gcs"}) {
      tocsin_msgs::msg::TransmissionState state;
      state.stamp().sec(static_cast<std::int32_t>(i));
      state.role(role);
      state.active(i != 2);
      state.qni(static_cast<float>(10 * i));
      const auto bytes = encode(type_info<tocsin_msgs::msg::TransmissionState>(), &state);
      (void)writer.write(decisions, {i, time_ns, time_ns, bytes.data(), bytes.size()});
    }
    tocsin_msgs::msg::NetworkQuality quality;
    quality.per_percent(i == 2 ? 100 : 0);
    quality.signal_dbm(i == 2 ? -99 : -45);
    quality.quality_percent(i == 2 ? 0 : 100);
    const auto bytes = encode(type_info<tocsin_msgs::msg::NetworkQuality>(), &quality);
    (void)writer.write(qualities, {i, time_ns, time_ns, bytes.data(), bytes.size()});
  }
}

TEST_F(QualityTraceTest, ReadsATopicOfABag) {
  write_bag(folder.path("bag"));
  const QualityTrace quality = read_quality_trace(folder.path("bag"), {});
  EXPECT_EQ(quality.qni, (std::vector<double>{100, 0, 100}));
  EXPECT_EQ(quality.time_s, (std::vector<double>{0, 1, 2}));
  TraceOptions options;
  options.topic = "transmission_state";
  options.role = Role::uxv;
  const QualityTrace decisions = read_quality_trace(folder.path("bag/bag_0.mcap"), options);
  EXPECT_EQ(decisions.qni, (std::vector<double>{10, 20, 30}));
  ASSERT_EQ(decisions.recorded.size(), 3U);
  EXPECT_FALSE(decisions.recorded[1].active);
}

TEST_F(QualityTraceTest, NamesTheTopicThatABagDoesNotHave) {
  write_bag(folder.path("bag"));
  TraceOptions options;
  options.topic = "location";
  try {
    (void)read_quality_trace(folder.path("bag"), options);
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("bag: has no message of topic location"));
  }
}

TEST_F(QualityTraceTest, ReadsRecordedDecisionsOfOneRole) {
  const std::string text = "receive_s,role,qni\n1,uxv,50\n1,gcs,60\n2,uxv,70\n";
  EXPECT_EQ(read(text, {"", Role::uxv, 1}).qni, (std::vector<double>{50, 70}));
  EXPECT_THAT(error_of("receive_s,role,qni\n1,gcs,60\n", {"", Role::uxv, 1}),
              HasSubstr("has no row with role uxv, only gcs"));
}

TEST_F(QualityTraceTest, AveragesMeasuredWifiOverSeconds) {
  const QualityTrace sut = read(
      "time_s,x_m,rssi_dbm,link_quality,link_quality_scale,ping_delay_ms\n"
      "0.1,0,-45,70,70,10\n0.6,0,-45,70,70,\n1.2,0,-99,0,100,2000\n");
  ASSERT_EQ(sut.qni.size(), 2U);
  EXPECT_NEAR(sut.qni[0], 80, 1e-9);  // half of the packets of this second were lost
  EXPECT_NEAR(sut.qni[1], 20, 1e-9);  // slow is half lost
  EXPECT_EQ(sut.bad, (std::vector<bool>{true, false}));  // half unanswered; all answered
}

TEST_F(QualityTraceTest, TakesTheColumnThatIsNamed) {
  EXPECT_EQ(read("a,b\n1,2\n", {"b", {}, 1}).qni, std::vector<double>{2});
  EXPECT_THAT(error_of("a,b\n1,2\n", {"c", {}, 1}), HasSubstr("has no column 'c', has: a, b"));
}

TEST_F(QualityTraceTest, HasOneClearErrorForEveryBadFile) {
  EXPECT_THAT(error_of(""), EndsWith("a.csv: is empty, must be CSV"));
  EXPECT_THAT(error_of("qni\n"), EndsWith("a.csv: has no row besides the first"));
  EXPECT_THAT(error_of("qni\n5\nabc\n"), EndsWith("a.csv:3: qni: 'abc' is not a number"));
  EXPECT_THAT(error_of("qni\n5\ninf\n"), HasSubstr("'inf' is not a number"));
  EXPECT_THAT(error_of("qni\n5x\n"), HasSubstr("'5x' is not a number"));
  EXPECT_THAT(error_of("t,qni\n1,2,3\n"),
              EndsWith("a.csv:2: 3 cells, must be 2 as in the first row"));
  EXPECT_THAT(error_of("t,quality\n1,2\n"),
              HasSubstr("has no column qni, per_percent or rssi_dbm"));
  EXPECT_THAT(error_of("qni\n101\n"), EndsWith("a.csv:2: qni: 101 is outside [0, 100]"));
  EXPECT_EQ(error_of("qni\n100\n"), "no error");
  EXPECT_THAT(error_of("t,qni\n1,7\n,2\n"), EndsWith("a.csv:3: t: must be a time, is absent"));
  EXPECT_THAT(error_of("t,qni\n1,7\nnan,2\n"), EndsWith("a.csv:3: t: must be a time, is absent"));
}

TEST_F(QualityTraceTest, NamesTheRowWhoseTimeGoesBack) {
  EXPECT_EQ(error_of("t,qni\n1,7\n1,7\n"), "no error");
  EXPECT_THAT(
      error_of("t,qni\n3,7\n3.5,7\n2.5,7\n"),
      EndsWith("a.csv:4: t: 2.5 is 1.000 s before the row above; rows must be in the order of "
               "time"));
}

TEST_F(QualityTraceTest, ShowsTextOfAFileWithoutControlCharacters) {
  EXPECT_THAT(error_of("qni\n\x1b[2J\n"), HasSubstr("'\\x1b[2J' is not a number"));
}

TEST_F(QualityTraceTest, RejectsWhatIsNoFile) {
  EXPECT_THROW((void)read_quality_trace("/nonexistent.csv", {}), ConfigError);
  EXPECT_THROW((void)read_quality_trace("/tmp", {}), ConfigError);
}

TEST_F(QualityTraceTest, ReadsQuotedCells) {
  EXPECT_EQ(read("note,qni\n\"a, \"\"b\"\"\",7\n").qni, std::vector<double>{7});
}

TEST(Duration, IsReadWithItsUnit) {
  EXPECT_EQ(parse_duration_s("x", "90"), 90);
  EXPECT_EQ(parse_duration_s("x", "90s"), 90);
  EXPECT_EQ(parse_duration_s("x", "1.5h"), 5400);
  EXPECT_EQ(parse_duration_s("x", "2d"), 172800);
  for (const char* bad : {"", "h", "1y", "-1h", "0", "nan", "1 h"}) {
    EXPECT_THROW((void)parse_duration_s("x", bad), ConfigError) << bad;
  }
}

}  // namespace
}  // namespace tocsin::tools
