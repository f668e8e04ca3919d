// SPDX-License-Identifier: Apache-2.0
#include "link_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin::top {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr Time t0{std::chrono::seconds(100)};

tocsin_msgs::msg::LinkState state_of(const std::string& role, float capacity = 180000) {
  tocsin_msgs::msg::LinkState state;
  state.role(role);
  state.live_peers(1);
  state.capacity_bytes_per_s(capacity);
  state.capacity_measured(true);
  state.classes().resize(2);
  state.classes()[0].traffic_class("critical");
  state.classes()[0].offered(40);
  state.classes()[1].traffic_class("low");
  return state;
}

std::string text_of(const std::vector<terminal::Line>& lines, bool colour = false) {
  std::string text;
  for (const auto& line : lines) text += terminal::to_text(line, 120, colour) + "\n";
  return text;
}

TEST(LinkTable, HasALineForEachWayWithTheLastThatWasTold) {
  LinkTable sut;
  EXPECT_TRUE(sut.lines(t0).empty());
  EXPECT_TRUE(sut.classes(t0, 80).empty()) << "a host without a router";
  sut.add(state_of("uxv", 1), t0);
  sut.add(state_of("gcs"), t0);
  sut.add(state_of("uxv", 90000), t0);
  const auto lines = sut.lines(t0);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_THAT(text_of({lines[0]}), HasSubstr("Downlink  180 kB/s, backlog 0 ms"));
  EXPECT_THAT(text_of({lines[1]}), HasSubstr("Uplink    90 kB/s"));
}

TEST(LinkTable, AStaleWayIsGreyAndHasNoClasses) {
  LinkTable sut;
  sut.add(state_of("uxv"), t0);
  EXPECT_THAT(text_of(sut.classes(t0 + seconds(3), 80)), HasSubstr("Uplink critical"));
  EXPECT_THAT(text_of(sut.lines(t0 + seconds(3.001))), HasSubstr(", 3 s ago"));
  EXPECT_THAT(text_of(sut.lines(t0 + seconds(3.001)), true), HasSubstr("\x1b[2m180 kB/s"));
  EXPECT_TRUE(sut.classes(t0 + seconds(3.001), 80).empty());
  EXPECT_EQ(text_of(sut.lines(t0 + seconds(31))), "Uplink    unknown for 31 s\n");
}

TEST(LinkTable, ForgetsAWayAfterTenMinutes) {
  LinkTable sut;
  sut.add(state_of("uxv"), t0);
  sut.add(state_of("gcs"), t0 + seconds(600));
  EXPECT_EQ(sut.lines(t0 + seconds(600)).size(), 2U);
  sut.add(state_of("gcs"), t0 + seconds(600.001));
  EXPECT_EQ(sut.lines(t0 + seconds(601)).size(), 1U);
}

}  // namespace
}  // namespace tocsin::top
