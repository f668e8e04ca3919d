// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "listener.hpp"
#include "runtime/sim_bus.hpp"
#include "talker.hpp"

namespace example {
namespace {

using ::testing::HasSubstr;

class GreetingsTest : public ::testing::Test {
 protected:
  tocsin::SimBus bus_;
  tocsin::Context talker_context_{bus_, "talker", "uxv", ""};
  tocsin::Context listener_context_{bus_, "listener", "uxv", ""};
};

TEST_F(GreetingsTest, TheTalkerCountsWhatItSays) {
  tocsin::SimReader<Greetings> heard(bus_);
  Talker talker(talker_context_, {"good morning", 0.5});
  bus_.add(talker);
  bus_.run_for(tocsin::seconds(10));
  const auto greetings = heard.take();
  ASSERT_NEAR(static_cast<double>(greetings.size()), 20, 2);
  for (std::size_t i = 0; i < greetings.size(); ++i) {
    EXPECT_EQ(greetings[i].text(), "good morning");
    EXPECT_EQ(greetings[i].number(), i + 1);
  }
}

TEST_F(GreetingsTest, TheListenerLogsWhatItHears) {
  Listener listener(listener_context_, {});
  bus_.add(listener);
  Greetings::Message greeting;
  greeting.text("hello");
  greeting.number(7);
  bus_.publish<Greetings>(greeting);
  ::testing::internal::CaptureStderr();
  bus_.run_for(tocsin::Duration::zero());
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), HasSubstr("heard hello, number 7"));
}

}  // namespace
}  // namespace example
