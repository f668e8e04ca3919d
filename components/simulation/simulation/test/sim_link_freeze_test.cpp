// SPDX-License-Identifier: Apache-2.0
// A router's process that computes nothing for a while.
#include <gtest/gtest.h>

#include "link_bus_fixture.hpp"

namespace tocsin::simulation {
namespace {

using link_event::HostSample;
using link_event::LinkSample;

StopValue pressed() {
  StopValue value;
  value.stands = true;
  value.number = 1;
  return value;
}

TEST_F(LinkBusTest, AFrozenRouterReceivesNothingAndNothingLater) {
  connect();
  const auto writer = drive_.advertise(endpoint<topic::Location>());
  run_for(1);
  down().process.freeze(true);
  (void)writer->write(message<topic::Location>());
  up().bus.say_stop(pressed());
  run_for(1);
  down().process.freeze(false);
  EXPECT_TRUE(down().bus.take_stop_news().packets.empty());
  run_for(1);
  EXPECT_EQ(down().count<LinkSample>(), 0U);
}

TEST_F(LinkBusTest, AFrozenRouterSendsNothingBetweenItsTicks) {
  connect();
  up().bus.say_stop(pressed());
  run_for(0.3);
  EXPECT_FALSE(down().bus.take_stop_news().packets.empty());
  up().process.freeze(true);
  run_for(0.05);  // what was on the air
  (void)down().bus.take_stop_news();
  const std::uint64_t before = up().bus.packets().packets;
  run_for(3);
  EXPECT_TRUE(down().bus.take_stop_news().packets.empty());
  EXPECT_EQ(up().bus.packets().packets, before);
}

TEST_F(LinkBusTest, WhatItsHostWritesWaitsForAFrozenRouter) {
  connect();
  const auto writer = drive_.advertise(endpoint<topic::Location>());
  run_for(1);
  up().process.freeze(true);
  (void)writer->write(message<topic::Location>());
  up().process.freeze(false);
  run_for(0.1);
  EXPECT_EQ(up().count<HostSample>(), 1U);
  EXPECT_EQ(down().count<LinkSample>(), 1U);
}

}  // namespace
}  // namespace tocsin::simulation
