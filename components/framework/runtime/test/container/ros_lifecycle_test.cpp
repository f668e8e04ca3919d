// SPDX-License-Identifier: Apache-2.0
#include "container/ros_lifecycle.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using State = LifecycleState;

RosTransition asked(std::uint8_t id, const char* label = "") {
  RosTransition transition;
  transition.id(id);
  transition.label(label);
  return transition;
}

/// "configure [1] unconfigured configuring" of each.
template <class Descriptions>
std::vector<std::string> lines(const Descriptions& all) {
  std::vector<std::string> texts;
  for (const auto& one : all) {
    texts.push_back(one.transition().label() + " [" + std::to_string(one.transition().id()) + "] " +
                    one.start_state().label() + " " + one.goal_state().label());
  }
  return texts;
}

TEST(RosLifecycle, StatesHaveTheNumbersAndLabelsOfRclLifecycle) {
  EXPECT_EQ(ros_state(State::unconfigured).id(), 1);
  EXPECT_EQ(ros_state(State::unconfigured).label(), "unconfigured");
  EXPECT_EQ(ros_state(State::active).id(), 3);
  EXPECT_EQ(ros_state(State::finalized).id(), 4);
  EXPECT_EQ(ros_state(State::error).id(), 15);
  EXPECT_EQ(ros_state(State::error).label(), "errorprocessing");
  EXPECT_EQ(ros_states().size(), 11U);
  EXPECT_EQ(ros_states().front().label(), "unknown");
}

TEST(RosLifecycle, FromEachStateTheTransitionsOfRclLifecycleLeadOut) {
  EXPECT_THAT(lines(ros_transitions(State::unconfigured)),
              ElementsAre("configure [1] unconfigured configuring",
                          "shutdown [5] unconfigured shuttingdown"));
  EXPECT_THAT(lines(ros_transitions(State::inactive)),
              ElementsAre("cleanup [2] inactive cleaningup", "activate [3] inactive activating",
                          "shutdown [6] inactive shuttingdown"));
  EXPECT_THAT(
      lines(ros_transitions(State::active)),
      ElementsAre("deactivate [4] active deactivating", "shutdown [7] active shuttingdown"));
  EXPECT_THAT(lines(ros_transitions(State::finalized)), IsEmpty());
  EXPECT_THAT(lines(ros_transitions(State::error)),
              ElementsAre("cleanup [2] errorprocessing cleaningup",
                          "shutdown [6] errorprocessing shuttingdown"));
}

TEST(RosLifecycle, EachWayOutIsOneThatTheLifecycleAllows) {
  for (const State from :
       {State::unconfigured, State::inactive, State::active, State::finalized, State::error}) {
    std::size_t allowed = 0;
    for (const char* word : {"configure", "activate", "deactivate", "cleanup", "shutdown"}) {
      const auto transition = to_transition(word).value();
      if (!after(from, transition)) continue;
      ++allowed;
      EXPECT_EQ(asked_transition(asked(0, word), from), transition) << word;
    }
    EXPECT_EQ(ros_transitions(from).size(), allowed) << to_text(from);
  }
  EXPECT_EQ(ros_transition_graph().size(), 18U);
}

TEST(RosLifecycle, ATransitionIsAskedForByItsLabelOrItsNumber) {
  EXPECT_EQ(asked_transition(asked(4), State::active), Transition::deactivate);
  EXPECT_EQ(asked_transition(asked(0, "deactivate"), State::active), Transition::deactivate);
  EXPECT_EQ(asked_transition(asked(99, "shutdown"), State::inactive), Transition::shutdown);
  EXPECT_EQ(asked_transition(asked(7), State::active), Transition::shutdown);
}

TEST(RosLifecycle, WhatIsNoTransitionFromHereIsNone) {
  EXPECT_FALSE(asked_transition(asked(4), State::inactive));
  EXPECT_FALSE(asked_transition(asked(5), State::active));
  EXPECT_FALSE(asked_transition(asked(4, "fly"), State::active));
  EXPECT_FALSE(asked_transition(asked(0), State::active));
}

TEST(RosLifecycle, AChangeIsToldAsTheWayIntoAndOutOfTheStateInBetween) {
  const auto events = transition_events(State::inactive, State::active, 17);
  EXPECT_THAT(lines(events), ElementsAre("activate [3] inactive activating",
                                         "transition_success [30] activating active"));
  EXPECT_EQ(events[0].timestamp(), 17U);
  EXPECT_THAT(lines(transition_events(State::active, State::finalized, 0)),
              ElementsAre("shutdown [7] active shuttingdown",
                          "transition_success [50] shuttingdown finalized"));
}

TEST(RosLifecycle, AnErrorIsToldAsOne) {
  EXPECT_THAT(lines(transition_events(State::active, State::error, 0)),
              ElementsAre("transition_error [12] active errorprocessing"));
  EXPECT_THAT(lines(transition_events(State::unconfigured, State::error, 0)),
              ElementsAre("transition_error [12] configuring errorprocessing"));
  EXPECT_THAT(lines(transition_events(State::error, State::unconfigured, 0)),
              ElementsAre("cleanup [2] errorprocessing cleaningup",
                          "transition_success [20] cleaningup unconfigured"));
}

TEST(RosLifecycle, WhatNoTransitionLeadsToIsNotTold) {
  EXPECT_THAT(transition_events(State::unconfigured, State::active, 0), IsEmpty());
  EXPECT_THAT(transition_events(State::active, State::active, 0), IsEmpty());
}

}  // namespace
}  // namespace tocsin
