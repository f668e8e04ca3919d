// SPDX-License-Identifier: Apache-2.0
// Hosts without routers.
#include "sim_host.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "link_bus_fixture.hpp"

namespace tocsin::simulation {
namespace {

using SimHostTest = LinkBusTest;

TEST_F(SimHostTest, SampleReachesEveryProcessOfItsHostAtOnceAsTheSameObject) {
  Reader& same = read<topic::Odom>(drive_);
  Reader& other = read<topic::Odom>(payload_);
  const auto written = message<topic::Odom>();
  const std::uint64_t before = core_.digest.value();
  EXPECT_EQ(drive_.advertise(endpoint<topic::Odom>())->write(written), Status::ok);
  EXPECT_NE(core_.digest.value(), before);
  EXPECT_EQ(core_.samples, 1U);
  ASSERT_EQ(same.samples.size(), 1U);
  ASSERT_EQ(other.samples.size(), 1U);
  EXPECT_EQ(other.samples[0].message, written);
  EXPECT_EQ(other.samples[0].received, core_.now);
}

TEST_F(SimHostTest, LateReaderOfItsHostGetsTheLastState) {
  write<topic::NavigationStatus>(drive_);
  EXPECT_EQ(read<topic::NavigationStatus>(drive_).samples.size(), 1U);
  EXPECT_EQ(read<topic::NavigationStatus>(payload_).samples.size(), 1U);
}

TEST_F(SimHostTest, WithoutARouterEachTopicStaysOnItsHost) {
  Reader& here = read<topic::Location>(payload_);
  Reader& away = read<topic::Location>(mission_);
  Reader& odom_away = read<topic::Odom>(mission_);
  write<topic::Location>(drive_);
  write<topic::Odom>(drive_);
  run_for(1);
  EXPECT_EQ(here.samples.size(), 1U);
  EXPECT_TRUE(away.samples.empty());
  EXPECT_TRUE(odom_away.samples.empty());
  EXPECT_EQ(link_.pushed(), 0U);
}

TEST_F(SimHostTest, ADestroyedSubscriptionGetsNothing) {
  Reader reader;
  (void)drive_.subscribe(endpoint<topic::Odom>(), reader);
  write<topic::Odom>(drive_);
  EXPECT_TRUE(reader.samples.empty());
}

TEST_F(SimHostTest, RefusesATopicThatItsRoleMayNotSendAndASecondType) {
  EXPECT_THROW((void)mission_.advertise(endpoint<topic::CpuLoad>()), ConfigError);
  (void)drive_.advertise(endpoint<topic::Odom>());
  const Endpoint other{topic::Odom::info, &type_info<topic::Imu::Message>()};
  for (SimProcess* process : {&drive_, &payload_}) {
    EXPECT_THROW((void)process->advertise(other), ConfigError);
  }
}

/// Topics of one of several vehicles, as the whole site sees them.
struct NavigationOfOne : topic::NavigationStatus {
  static constexpr TopicInfo info{"uxv1/navigation_status", topic::NavigationStatus::info.qos,
                                  Scope::host};
};
struct MissionOfOne : topic::MissionStatus {
  static constexpr TopicInfo info{"uxv1/mission_status", topic::MissionStatus::info.qos,
                                  Scope::host};
};

TEST_F(SimHostTest, WhatServesAllVehiclesMeetsTheTopicsOfEachByTheirNamespace) {
  Network site{core_, link_, QosProfiles(TOCSIN_REPOSITORY "/config/qos.yaml")};
  site.homes[{"gcs", "uxv1"}] = &gcs_;
  SimHost station(site, "gcs", Role::gcs, TOCSIN_REPOSITORY "/config/traffic.yaml");
  SimProcess& common = station.add_process("common");
  Reader of_one;
  Reader of_none;
  const auto one = common.subscribe(endpoint<NavigationOfOne>(), of_one);
  const auto none = common.subscribe(endpoint<topic::NavigationStatus>(), of_none);
  connect();
  Reader& on_board = read<topic::MissionStatus>(drive_);
  write<topic::NavigationStatus>(drive_);
  write<MissionOfOne>(common);
  run_for(1);
  EXPECT_EQ(of_one.samples.size(), 1U) << "it crossed the link";
  EXPECT_TRUE(of_none.samples.empty()) << "that is of no vehicle";
  EXPECT_EQ(on_board.samples.size(), 1U) << "and so did this";
}

}  // namespace
}  // namespace tocsin::simulation
