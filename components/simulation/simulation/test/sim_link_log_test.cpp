// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <vector>

#include "link_bus_fixture.hpp"

namespace tocsin::simulation {
namespace {

using link_event::HostSample;

TEST_F(LinkBusTest, WhatALogHeldIsGivenByANextLife) {
  connect();
  write<topic::Location>(drive_);
  run_for(1);
  const CarriedSample logged = up().got<HostSample>().at(0).sample;
  const auto bytes = up().bus.bytes_of(logged);
  EXPECT_EQ(bytes.size(), logged.bytes);
  kill_router(uxv_);
  start(uxv_);
  CarriedSample again = up().bus.sample_of(bytes);
  again.source = logged.source;
  again.sequence = logged.sequence;
  EXPECT_EQ(again.content, logged.content);
  Flow flow;
  flow.topic = topic::Location::info.name;
  Reader& away = read<topic::Location>(mission_);
  down().bus.deliver(down().bus.offer(flow), again);
  EXPECT_EQ(away.samples.size(), 1U);
  EXPECT_EQ(up().bus.sample_of({1, 2, 3}).content, nullptr);
  EXPECT_EQ(up().bus.sample_of(std::vector<std::uint8_t>(8, 0xff)).content, nullptr);
}

}  // namespace
}  // namespace tocsin::simulation
