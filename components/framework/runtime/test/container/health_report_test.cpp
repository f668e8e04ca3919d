// SPDX-License-Identifier: Apache-2.0
#include "container/health_report.hpp"
#include "runtime/host_control.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin {
namespace {

using namespace diagnostic_msgs::msg::DiagnosticStatus_Constants;
using ::testing::HasSubstr;

constexpr Time t0{std::chrono::seconds(100)};

/// An active component that ticked 100 times in the last second, 1 ms each.
InstanceHealth healthy() {
  InstanceHealth health;
  health.name = "pilot";
  health.state = "active";
  health.before.at = t0;
  health.now.at = t0 + seconds(1);
  health.now.ticks.ticks = 100;
  health.now.ticks.total = seconds(0.1);
  health.now.ticks.longest = seconds(0.002);
  health.now.ticks.buckets[19] = 100;  // 0.5 to 1 ms
  return health;
}

std::string value(const Diagnostic& status, const std::string& key) {
  for (const auto& pair : status.values()) {
    if (pair.key() == key) return pair.value();
  }
  return "none";
}

Diagnostic sut(const InstanceHealth& health) { return diagnose("drive", health, HealthLimits{}); }

TEST(HealthReport, AHealthyComponentIsOkAndTellsItsFigures) {
  const Diagnostic status = sut(healthy());
  EXPECT_EQ(status.level(), OK);
  EXPECT_EQ(status.name(), "drive/pilot");
  EXPECT_EQ(status.message(), "active");
  EXPECT_EQ(value(status, "rate_hz"), "100.00");
  EXPECT_EQ(value(status, "tick_mean_s"), "0.001000");
  EXPECT_EQ(value(status, "tick_max_s"), "0.002000");
  EXPECT_EQ(value(status, "tick_p99_s"), "0.001049");
}

TEST(HealthReport, DroppedPacketsAreAFindingWhileTheyComeAndHistoryAfterwards) {
  using rtps_filter::DropReason;
  rtps_filter::DropAccount account;
  account.add(DropReason::gap_range, rtps_filter::ipv4(10, 0, 0, 9));
  account.add(DropReason::gap_range, rtps_filter::ipv4(10, 0, 0, 9));
  account.add(DropReason::not_rtps, rtps_filter::ipv4(10, 0, 0, 8));
  const Diagnostic now = diagnose("drive", account, {});
  EXPECT_EQ(now.level(), WARN);
  EXPECT_EQ(now.name(), "drive/packets dropped");
  EXPECT_EQ(now.message(), "3 packets dropped, from 10.0.0.8: not_rtps 1; 10.0.0.9: gap_range 2");
  EXPECT_EQ(value(now, "gap_range"), "2");
  const Diagnostic later = diagnose("drive", account, account);
  EXPECT_EQ(later.level(), OK);
  EXPECT_EQ(later.message(), "past events");
  EXPECT_EQ(value(later, "dropped"), "3");
  EXPECT_EQ(value(later, "from 10.0.0.9"), "gap_range 2");
  EXPECT_EQ(value(later, "fragment"), "none");
}

TEST(HealthReport, WhatTheRouterRefusesIsAFindingWhileItComesAndHistoryAfterwards) {
  RefusedNames refused;
  (void)refused.add("topic cmd_vel", "gcs");
  const RefusedNames before = refused;
  (void)refused.add("topic cmd_vel", "gcs");
  (void)refused.add("topic odom", "stranger");
  const Diagnostic now = diagnose("link", refused, before);
  EXPECT_EQ(now.level(), WARN);
  EXPECT_EQ(now.name(), "link/link refused");
  EXPECT_EQ(now.message(),
            "2 refused on the link: topic cmd_vel from gcs, topic odom from stranger");
  EXPECT_EQ(value(now, "topic cmd_vel from gcs"), "2");
  const Diagnostic later = diagnose("link", refused, refused);
  EXPECT_EQ(later.level(), OK);
  EXPECT_EQ(value(later, "topic odom from stranger"), "1");
}

TEST(HealthReport, WarnsOnlyOfATickLongerThanTheLimit) {
  InstanceHealth health = healthy();
  health.now.ticks.longest = seconds(0.5);
  EXPECT_EQ(sut(health).level(), OK);
  health.now.ticks.longest = seconds(0.501);
  EXPECT_EQ(sut(health).level(), WARN);
}

TEST(HealthReport, ATickThatStillRunsIsSeenBeforeItEnds) {
  InstanceHealth health = healthy();
  health.now.ticks.running_since = health.now.at - seconds(5);
  EXPECT_EQ(sut(health).level(), WARN);
  health.now.ticks.running_since = health.now.at - seconds(5.1);
  EXPECT_EQ(sut(health).level(), ERROR);
  EXPECT_THAT(sut(health).message(), HasSubstr("blocks: a tick has been running for 5.1 s"));
}

TEST(HealthReport, AFloodedInputIsAWarningWhileItLasts) {
  InstanceHealth health = healthy();
  health.before.ports = {{"odom", 10, 3, 0, t0}};
  health.now.ports = {{"odom", 20, 3, 64, t0}};
  EXPECT_EQ(sut(health).level(), OK);
  health.now.ports[0].dropped = 4;
  EXPECT_EQ(sut(health).level(), WARN);
  EXPECT_EQ(sut(health).message(), "flooded: 1 samples of odom dropped");
}

TEST(HealthReport, TellsDepthDropsAndAgeOfEachInput) {
  InstanceHealth health = healthy();
  health.now.ports = {{"odom", 20, 0, 7, t0 + seconds(0.75)}, {"goal", 0, 0, 0, Time{}}};
  const Diagnostic status = sut(health);
  EXPECT_EQ(value(status, "odom.depth"), "7");
  EXPECT_EQ(value(status, "odom.age_s"), "0.250");
  EXPECT_EQ(value(status, "goal.age_s"), "never");
}

TEST(HealthReport, WarnsWhenMoreThanATenthOfThePeriodsWasSkipped) {
  InstanceHealth health = healthy();
  health.now.overruns = 11;  // of 111
  EXPECT_EQ(sut(health).level(), OK);
  health.now.overruns = 12;  // of 112
  EXPECT_EQ(sut(health).level(), WARN);
}

TEST(HealthReport, AnErrorTellsWhatWasThrown) {
  InstanceHealth health = healthy();
  health.state = "error";
  health.error = "broken";
  EXPECT_EQ(sut(health).level(), ERROR);
  EXPECT_EQ(sut(health).message(), "threw: broken");
}

TEST(HealthReport, TwoNodesOfOneNameAreAnError) {
  InstanceHealth health = healthy();
  health.twin = "payload (process 7)";
  EXPECT_EQ(sut(health).level(), ERROR);
  EXPECT_THAT(sut(health).message(), HasSubstr("two nodes of one name"));
}

TEST(HealthReport, AnInactiveComponentIsOk) {
  InstanceHealth health = healthy();
  health.state = "inactive";
  health.now.ticks.longest = seconds(3);
  EXPECT_EQ(sut(health).level(), OK);
  EXPECT_EQ(sut(health).message(), "inactive");
}

TEST(HealthReport, WarnsOfMemoryBeyondLimitAndOfGrowth) {
  constexpr std::uint64_t mib = 1024 * 1024;
  const auto level = [](std::uint64_t now, std::uint64_t first) {
    return diagnose("drive", ProcessFigures{now * mib, first * mib, "", {}}, HealthLimits{})
        .level();
  };
  EXPECT_EQ(level(512, 500), OK);
  EXPECT_EQ(level(513, 500), WARN);
  EXPECT_EQ(level(84, 20), OK);
  EXPECT_EQ(level(85, 20), WARN);
}

TEST(HealthReport, SaysThatTheDiskIsFullAndBeforeThatItBecomesSo) {
  constexpr std::uint64_t mib = 1024 * 1024;
  const auto status = [](std::optional<std::uint64_t> free) {
    return diagnose("drive", ProcessFigures{mib, mib, "/runs/a", free}, HealthLimits{});
  };
  EXPECT_EQ(status(100 * mib).level(), OK);
  EXPECT_EQ(status(100 * mib - 1).level(), WARN);
  EXPECT_EQ(status(mib).level(), WARN);
  EXPECT_EQ(status(mib - 1).level(), ERROR);
  EXPECT_EQ(status(0).message(), "disk of /runs/a is full: recordings and logs are lost");
  EXPECT_EQ(status(std::nullopt).level(), OK);
  EXPECT_EQ(status(0).values().front().key(), "disk_free_mib");
}

TEST(HealthReport, AnIncompatibleEndIsNamedWithItsPolicies) {
  EndpointHealth endpoint;
  endpoint.topic = "odom";
  EXPECT_FALSE(is_eventful(endpoint));
  endpoint.misfit = "reliability (gcs_view)";
  EXPECT_TRUE(is_eventful(endpoint));
  const Diagnostic status = diagnose("drive", endpoint, endpoint);
  EXPECT_EQ(status.level(), ERROR);
  EXPECT_EQ(status.message(), "incompatible QoS: reliability (gcs_view)");
  EXPECT_EQ(status.name(), "drive/odom reader");
}

TEST(HealthReport, AnIncompatibleEndThatHasLeftIsHistory) {
  EndpointHealth endpoint;
  endpoint.topic = "odom";
  endpoint.incompatible_qos = 3;
  endpoint.incompatible_policy = "reliability";
  EXPECT_TRUE(is_eventful(endpoint));
  const Diagnostic status = diagnose("drive", endpoint, endpoint);
  EXPECT_EQ(status.level(), OK);
  EXPECT_EQ(status.message(), "past events");
  EXPECT_EQ(value(status, "incompatible_qos"), "3");
}

TEST(HealthReport, ATypeOfAnotherLayoutIsAnError) {
  EndpointHealth endpoint;
  endpoint.topic = "odom";
  endpoint.other_type = "nav_msgs::msg::dds_::Odometry_ with another layout";
  EXPECT_TRUE(is_eventful(endpoint));
  const Diagnostic status = diagnose("drive", endpoint, endpoint);
  EXPECT_EQ(status.level(), ERROR);
  EXPECT_EQ(status.message(),
            "another end has the type nav_msgs::msg::dds_::Odometry_ with another layout");
}

TEST(HealthReport, LossesAndMissedDeadlinesWarnOnlyWhileTheyGrow) {
  EndpointHealth before;
  before.topic = "odom";
  before.lost = before.deadlines_missed = before.liveliness_lost = before.rejected = 1;
  EXPECT_EQ(diagnose("drive", before, before).level(), OK);
  for (auto counter : {&EndpointHealth::lost, &EndpointHealth::deadlines_missed,
                       &EndpointHealth::liveliness_lost, &EndpointHealth::rejected}) {
    EndpointHealth now = before;
    ++(now.*counter);
    EXPECT_EQ(diagnose("drive", now, before).level(), WARN);
  }
}

}  // namespace
}  // namespace tocsin
