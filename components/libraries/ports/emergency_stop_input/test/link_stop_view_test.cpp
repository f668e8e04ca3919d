// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop_input/link_stop_view.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const Time t0 = Time{} + seconds(100);
constexpr Duration limit = LinkStopView::silent_after;
constexpr Duration tick{1};
const LinkStopView::Values quiet{};
const LinkStopView::Values pressed{true, {"station"}, 0};

LinkStopView::Values released(std::uint64_t releases) { return {false, {}, releases}; }

TEST(LinkStopView, NothingStandsBeforeTheFirstMessage) {
  const LinkStopView sut;
  EXPECT_FALSE(sut.stands(t0 + seconds(1e6)));
  EXPECT_THAT(sut.stopped_by(t0), IsEmpty());
  EXPECT_EQ(sut.deadline(t0), never);
}

TEST(LinkStopView, StandsWhileTheLastMessageSaysSo) {
  LinkStopView sut;
  EXPECT_FALSE(sut.on_message(pressed, t0));
  EXPECT_TRUE(sut.stands(t0));
  EXPECT_THAT(sut.stopped_by(t0), ElementsAre("station"));
  EXPECT_FALSE(sut.on_message(quiet, t0));
  EXPECT_FALSE(sut.stands(t0));
  EXPECT_THAT(sut.stopped_by(t0), IsEmpty());
}

TEST(LinkStopView, AStopHasANameThoughTheRouterSaysNone) {
  LinkStopView sut;
  (void)sut.on_message({true, {}, 0}, t0);
  EXPECT_THAT(sut.stopped_by(t0), ElementsAre("link"));
}

TEST(LinkStopView, ARouterThatFallsSilentIsAStop) {
  LinkStopView sut;
  (void)sut.on_message(quiet, t0);
  EXPECT_EQ(sut.deadline(t0), t0 + limit);
  EXPECT_FALSE(sut.stands(t0 + limit - tick));
  EXPECT_TRUE(sut.stands(t0 + limit));
  EXPECT_THAT(sut.stopped_by(t0 + limit), ElementsAre("link_router is silent"));
  EXPECT_EQ(sut.deadline(t0 + limit), never);
  (void)sut.on_message(quiet, t0 + seconds(60));
  EXPECT_FALSE(sut.stands(t0 + seconds(60)));
}

TEST(LinkStopView, SilenceReleasesNothing) {
  LinkStopView sut;
  (void)sut.on_message(pressed, t0);
  EXPECT_THAT(sut.stopped_by(t0 + limit), ElementsAre("station", "link_router is silent"));
}

TEST(LinkStopView, TellsEachReleaseOnce) {
  LinkStopView sut;
  EXPECT_FALSE(sut.on_message(released(7), t0)) << "of before it listened";
  EXPECT_FALSE(sut.on_message(released(7), t0));
  EXPECT_TRUE(sut.on_message(released(8), t0));
  EXPECT_FALSE(sut.on_message(released(8), t0));
  EXPECT_TRUE(sut.on_message(released(11), t0)) << "messages may be lost";
}

TEST(LinkStopView, ARouterThatBeginsToCountAnewReleasesNothing) {
  LinkStopView sut;
  (void)sut.on_message(released(7), t0);
  EXPECT_FALSE(sut.on_message(released(0), t0));
  EXPECT_TRUE(sut.on_message(released(1), t0));
}

TEST(LinkStopView, WhatStoodBeforeARestartStandsUntilTheFirstMessage) {
  LinkStopView before;
  (void)before.on_message(pressed, t0);
  LinkStopView sut;
  sut.restore(before.memory(t0), t0);
  EXPECT_TRUE(sut.stands(t0));
  EXPECT_THAT(sut.stopped_by(t0), ElementsAre("link, before a restart"));
  EXPECT_FALSE(sut.on_message(released(3), t0)) << "releases are not counted over a restart";
  EXPECT_FALSE(sut.stands(t0));
}

TEST(LinkStopView, ARouterThatWasReceivedBeforeARestartIsExpectedAfterIt) {
  LinkStopView before;
  (void)before.on_message(quiet, t0);
  LinkStopView sut;
  sut.restore(before.memory(t0), t0);
  EXPECT_FALSE(sut.stands(t0 + limit - tick));
  EXPECT_TRUE(sut.stands(t0 + limit));
}

TEST(LinkStopView, NothingStandsAgainAndNothingIsExpectedWhereThereWasNoRouter) {
  LinkStopView sut;
  sut.restore(LinkStopView().memory(t0), t0);
  EXPECT_FALSE(sut.stands(t0 + seconds(1e6)));
}

TEST(LinkStopView, SilenceIsKeptOverARestart) {
  LinkStopView before;
  (void)before.on_message(quiet, t0);
  LinkStopView sut;
  sut.restore(before.memory(t0 + limit), t0 + limit);
  EXPECT_TRUE(sut.stands(t0 + limit));
}

}  // namespace
}  // namespace tocsin
