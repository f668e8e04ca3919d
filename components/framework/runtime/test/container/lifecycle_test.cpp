// SPDX-License-Identifier: Apache-2.0
#include "container/lifecycle.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

using State = LifecycleState;

TEST(Lifecycle, GoesUpAndDownTheWholeWay) {
  EXPECT_EQ(after(State::unconfigured, Transition::configure), State::inactive);
  EXPECT_EQ(after(State::inactive, Transition::activate), State::active);
  EXPECT_EQ(after(State::active, Transition::deactivate), State::inactive);
  EXPECT_EQ(after(State::inactive, Transition::cleanup), State::unconfigured);
}

TEST(Lifecycle, AnErrorIsLeftByCleanupOrShutdownOnly) {
  EXPECT_EQ(after(State::error, Transition::cleanup), State::unconfigured);
  EXPECT_EQ(after(State::error, Transition::shutdown), State::finalized);
  EXPECT_FALSE(after(State::error, Transition::configure));
  EXPECT_FALSE(after(State::error, Transition::activate));
}

TEST(Lifecycle, NothingLeavesTheFinalState) {
  for (const char* word : {"configure", "activate", "deactivate", "cleanup", "shutdown"}) {
    EXPECT_FALSE(after(State::finalized, to_transition(word).value())) << word;
  }
}

TEST(Lifecycle, RefusesToSkipAState) {
  EXPECT_FALSE(after(State::unconfigured, Transition::activate));
  EXPECT_FALSE(after(State::active, Transition::cleanup));
  EXPECT_FALSE(after(State::active, Transition::configure));
  EXPECT_FALSE(after(State::inactive, Transition::deactivate));
}

TEST(Lifecycle, SpeaksTheNamesOfRos2) {
  EXPECT_STREQ(to_text(State::unconfigured), "unconfigured");
  EXPECT_STREQ(to_text(State::finalized), "finalized");
  EXPECT_EQ(to_transition("activate"), Transition::activate);
  EXPECT_FALSE(to_transition("start"));
}

}  // namespace
}  // namespace tocsin
