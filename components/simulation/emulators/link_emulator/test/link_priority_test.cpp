// SPDX-License-Identifier: Apache-2.0
// The TOS byte of real packets decides who goes first.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "harness.hpp"

namespace tocsin::link {
namespace {

/// How many of 60 long datagrams of the background come before one of CS6 that was sent after them.
/// Each takes 2 ms on the air.
int background_before_voice(Ends& ends) {
  constexpr int voice = 1000;
  ends.uxv.set_dscp(8);
  for (int i = 0; i < 60; ++i) ends.uxv.send(i, 1400);
  ends.uxv.set_dscp(48);
  ends.uxv.send(voice, 100);
  int before = 0;
  for (auto number = ends.gcs.receive(1000); number && *number != voice;
       number = ends.gcs.receive(1000)) {
    ++before;
  }
  while (ends.gcs.receive(100)) {
  }
  return before;
}

const char* six_mbits =
    "radio_channel: {tx_dbm: -47, shadowing_sigma_db: 0, rician_k_clear_db: 60, "
    "access_categories: ";

TEST_F(LinkEmulator, APacketOfCs6OvertakesTheBackgroundThatItsSenderHasQueued) {
  Emulator sut(std::string(six_mbits) + "true}");
  ASSERT_TRUE(sut.ready());
  Ends ends;
  int fewest = 60;  // a pause of the machine between the datagrams lets the background go first
  for (int i = 0; i < 5 && fewest > 20; ++i) {
    fewest = std::min(fewest, background_before_voice(ends));
  }
  EXPECT_LE(fewest, 20);
}

TEST_F(LinkEmulator, WithoutAccessCategoriesPacketsKeepTheirOrder) {
  Emulator sut(std::string(six_mbits) + "false}");
  ASSERT_TRUE(sut.ready());
  Ends ends;
  EXPECT_GE(background_before_voice(ends), 55);  // the air may lose a few
}

TEST_F(LinkEmulator, CountsThePacketsOfEachCategoryByTheirTosByte) {
  Emulator sut(open_channel);
  ASSERT_TRUE(sut.ready());
  Ends ends;
  int sent = 0;
  for (const int dscp : {48, 32, 32, 0, 0, 0, 8, 8, 8, 8}) {
    ends.uxv.set_dscp(dscp);
    ends.uxv.send(++sent, 100);
  }
  for (int i = 0; i < sent; ++i) ASSERT_TRUE(ends.gcs.receive(2000));
  const auto categories = sut.next_stats()["uplink"]["categories"];
  EXPECT_EQ(categories["voice"]["delivered"], 1);
  EXPECT_EQ(categories["video"]["delivered"], 2);
  EXPECT_EQ(categories["best_effort"]["delivered"], 3);
  EXPECT_EQ(categories["background"]["delivered"], 4);
}

}  // namespace
}  // namespace tocsin::link
