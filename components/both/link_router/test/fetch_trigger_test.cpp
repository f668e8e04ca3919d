// SPDX-License-Identifier: Apache-2.0
#include "backfill/fetch_trigger.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include <string>

#include "foundation/error.hpp"
#include "ros_idl/nav_msgs.hpp"
#include "runtime/sim_bus.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

/// A component that counts the events of a rule.
class Watching final : public Component {
 public:
  Watching(Context& context, const FetchRule& rule) : Component(context), trigger_(*this, rule) {
    wake_every(std::chrono::milliseconds(100));
  }
  void tick(Time) override {
    if (const auto event = trigger_.take()) {
      ++events;
      last = *event;
    }
  }
  int events = 0;
  Time last{};

 private:
  FetchTrigger trigger_;
};

FetchRule around_stop() {
  FetchRule rule;
  rule.when = topic::SafetyStatus::info.name;
  rule.field = "emergency_stop";
  rule.topics = {"*"};
  return rule;
}

class FetchTriggerTest : public ::testing::Test {
 protected:
  FetchTriggerTest() { bus_.add(sut_); }
  void stop(bool on, double then_s) {
    tocsin_msgs::msg::SafetyStatus message;
    message.emergency_stop(on);
    bus_.publish<topic::SafetyStatus>(message);
    bus_.run_for(seconds(then_s));
  }
  SimBus bus_;
  Context context_{bus_, "watching", Role::uxv};
  Watching sut_{context_, around_stop()};
};

TEST_F(FetchTriggerTest, AnEventBeginsWithTheFirstSampleThatFulfilsTheRule) {
  stop(false, 1);
  EXPECT_EQ(sut_.events, 0);
  const Time before = bus_.now();
  stop(true, 1);
  EXPECT_EQ(sut_.events, 1);
  EXPECT_EQ(sut_.last, before);
}

TEST_F(FetchTriggerTest, WhatIsSaidAgainIsTheSameEventHoweverLong) {
  for (int i = 0; i < 20; ++i) stop(true, 1);
  EXPECT_EQ(sut_.events, 1);
  stop(false, 4);
  stop(true, 0.2);
  EXPECT_EQ(sut_.events, 1) << "5 s after the last one at most";
  stop(false, 5);
  stop(true, 0.2);
  EXPECT_EQ(sut_.events, 2);
}

TEST_F(FetchTriggerTest, AStateThatHoldsOnIsTheSameEventHoweverSeldomItIsSaid) {
  stop(true, 30);
  stop(true, 30);
  EXPECT_EQ(sut_.events, 1);
  stop(false, 10);
  stop(true, 1);
  EXPECT_EQ(sut_.events, 2);
}

TEST_F(FetchTriggerTest, ANumberIsBetweenItsBounds) {
  FetchRule rule = around_stop();
  rule.when = topic::Odom::info.name;
  rule.field = "twist.twist.linear.x";
  rule.above = 0.5;
  rule.below = 1;
  rule.min_interval_s = 0;
  Watching sut(context_, rule);
  bus_.add(sut);
  nav_msgs::msg::Odometry odom;
  const auto events_at = [&](double x) {
    const int before = sut.events;
    odom.twist().twist().linear().x(x);
    bus_.publish<topic::Odom>(odom);
    bus_.run_for(seconds(0.2));
    return sut.events - before;
  };
  for (const double x : {0.25, 0.5, 1.0, std::nan("")}) EXPECT_EQ(events_at(x), 0) << x;
  EXPECT_EQ(events_at(0.75), 1);
}

TEST_F(FetchTriggerTest, NamesATopicOrFieldThatNobodyKnows) {
  const struct {
    const char* when;
    const char* field;
    const char* error;
  } cases[] = {
      {"emergency_stp", "",
       "uxv.fetch[2].when: no installed package knows a topic emergency_stp; did you mean "
       "'emergency_stop'"},
      {"odom", "twist.twist.linear.y2",
       "odom has no number or truth twist.twist.linear.y2; did you mean"},
      {"odom", "twist", "uxv.fetch[2].field: odom has no number or truth twist"},
      {"odom", "pose.covariance", "has no number or truth pose.covariance"},
      {"odom", "header.frame_id", "has no number or truth header.frame_id"},
  };
  for (const auto& one : cases) {
    FetchRule rule = around_stop();
    rule.when = one.when;
    rule.field = one.field;
    rule.name = "uxv.fetch[2]";
    try {
      const Watching other(context_, rule);
      ADD_FAILURE() << one.field;
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr(one.error));
    }
  }
}

}  // namespace
}  // namespace tocsin
