// SPDX-License-Identifier: Apache-2.0
#include "live_view/traffic_table.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

const Time t0{std::chrono::hours(1)};

tocsin_msgs::msg::TrafficReport report(const std::string& topic, const std::string& traffic_class,
                                       std::uint64_t sent) {
  tocsin_msgs::msg::TrafficReport message;
  message.topics().resize(1);
  message.topics()[0].topic(topic);
  message.topics()[0].traffic_class(traffic_class);
  message.topics()[0].sent(sent);
  return message;
}

TEST(TrafficTable, CountsBothSidesFromTheFirstReportOn) {
  TrafficTable sut;
  sut.on_sample("camera", t0);
  sut.on_report(report("camera", "low", 100), t0);
  sut.on_sample("camera", t0);
  sut.on_sample("camera", t0);
  sut.on_report(report("camera", "low", 104), t0);
  const auto rows = sut.rows(t0);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].sent, 4U);
  EXPECT_EQ(rows[0].received, 2U);
}

TEST(TrafficTable, TellsWhatCompressionLeavesOfATopic) {
  TrafficTable sut;
  auto message = report("odom", "high", 100);
  sut.on_report(message, t0);
  EXPECT_FALSE(sut.rows(t0)[0].size);
  message.topics()[0].plain_bytes(72'400);
  message.topics()[0].sent_bytes(9'050);
  sut.on_report(message, t0);
  EXPECT_EQ(sut.rows(t0)[0].size, 0.125);
}

TEST(TrafficTable, StartsAgainWhenTheWriterWasRestarted) {
  TrafficTable sut;
  sut.on_report(report("camera", "low", 100), t0);
  sut.on_sample("camera", t0);
  sut.on_report(report("camera", "low", 3), t0);
  sut.on_sample("camera", t0);
  sut.on_report(report("camera", "low", 5), t0);
  EXPECT_EQ(sut.rows(t0)[0].sent, 2U);
  EXPECT_EQ(sut.rows(t0)[0].received, 1U);
}

TEST(TrafficTable, AddsUpTheProcessesThatWriteATopic) {
  TrafficTable sut;
  for (const std::uint64_t sent : {10U, 13U}) {
    for (const char* process : {"drive", "link"}) {
      auto message = report("traffic_report", "critical", sent);
      message.process(process);
      sut.on_report(message, t0);
    }
  }
  EXPECT_EQ(sut.rows(t0)[0].sent, 6U);
}

TEST(TrafficTable, RateCountsTheLastFiveSeconds) {
  TrafficTable sut;
  sut.on_report(report("camera", "low", 0), t0);
  for (int i = 0; i < 10; ++i) sut.on_sample("camera", t0 + seconds(i));
  EXPECT_DOUBLE_EQ(sut.rows(t0 + seconds(9))[0].rate_hz, 6.0 / 5.0);
  EXPECT_DOUBLE_EQ(sut.rows(t0 + seconds(30))[0].rate_hz, 0.0);
  EXPECT_EQ(sut.rows(t0 + seconds(30))[0].age, seconds(21));
}

TEST(TrafficTable, OrdersByClass) {
  TrafficTable sut;
  sut.on_report(report("a", "low", 0), t0);
  sut.on_report(report("b", "other", 0), t0);
  sut.on_report(report("c", "critical", 0), t0);
  sut.on_report(report("d", "high", 0), t0);
  std::string order;
  for (const TrafficRow& row : sut.rows(t0)) order += row.topic;
  EXPECT_EQ(order, "cdab");
}

Counting counting(TrafficTable& sut) { return sut.rows(t0).at(0).counting; }

TEST(TrafficTable, ATopicThatNobodyReadsHereIsNotCalledLost) {
  TrafficTable sut;
  sut.on_report(report("my_topic", "low", 58), t0);
  EXPECT_EQ(counting(sut), Counting::not_read);
  sut.on_reader("my_topic", {});
  EXPECT_EQ(counting(sut), Counting::counted);
}

TEST(TrafficTable, AReaderThatFoundNoWriterSaysSoUntilSomethingComes) {
  TrafficTable sut;
  sut.on_report(report("camera", "low", 58), t0);
  sut.on_reader("camera", {0, false});
  EXPECT_EQ(counting(sut), Counting::no_match);
  sut.on_reader("camera", {1, false});
  EXPECT_EQ(counting(sut), Counting::counted);
  sut.on_sample("camera", t0);
  sut.on_reader("camera", {0, false});  // the writer has left
  EXPECT_EQ(counting(sut), Counting::counted);
}

TEST(TrafficTable, AReaderThatThinsIsNotSaidToLose) {
  TrafficTable sut;
  sut.on_report(report("camera", "low", 58), t0);
  sut.on_reader("camera", {1, true});
  EXPECT_EQ(counting(sut), Counting::thinned);
}

TEST(TrafficTable, TellsHowOldTheReportIs) {
  TrafficTable sut;
  EXPECT_EQ(sut.reported("camera"), std::nullopt);
  sut.on_sample("camera", t0);
  EXPECT_EQ(sut.reported("camera"), std::nullopt);
  sut.on_report(report("camera", "low", 1), t0 + seconds(2));
  EXPECT_EQ(sut.reported("camera"), t0 + seconds(2));
  EXPECT_EQ(sut.rows(t0 + seconds(5))[0].report_age, seconds(3));
}

}  // namespace
}  // namespace tocsin
