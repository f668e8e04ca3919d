// SPDX-License-Identifier: Apache-2.0
#include "link_router/gate_keeper.hpp"

#include <gtest/gtest.h>

namespace tocsin::router {
namespace {

const Time t0{std::chrono::hours(1)};

TEST(GateKeeper, IsOpenBeforeAnyState) {
  EXPECT_TRUE(GateKeeper(seconds(5)).open(t0));
  EXPECT_EQ(GateKeeper(seconds(5)).deadline(t0), never);
}

TEST(GateKeeper, FollowsTheState) {
  GateKeeper sut(seconds(5));
  sut.on_state(false, t0);
  EXPECT_FALSE(sut.open(t0));
  sut.on_state(true, t0 + seconds(1));
  EXPECT_TRUE(sut.open(t0 + seconds(1)));
}

TEST(GateKeeper, OpensOnlyAfterSilenceLongerThanTheLimit) {
  GateKeeper sut(seconds(5));
  sut.on_state(false, t0);
  EXPECT_FALSE(sut.open(t0 + seconds(5)));
  const Time deadline = sut.deadline(t0 + seconds(5));
  EXPECT_TRUE(sut.open(deadline));
  EXPECT_EQ(sut.deadline(deadline), never);
}

}  // namespace
}  // namespace tocsin::router
