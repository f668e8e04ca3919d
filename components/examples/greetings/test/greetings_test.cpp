// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "listener.hpp"
#include "runtime/sim_bus.hpp"
#include "talker.hpp"

namespace example {
namespace {

using ::testing::HasSubstr;

class GreetingsTest : public ::testing::Test {
 protected:
  tocsin::SimBus bus_;
  tocsin::Context talker_context_{bus_, "talker", tocsin::Role::uxv};
  tocsin::Context listener_context_{bus_, "listener", tocsin::Role::uxv};
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

TEST_F(GreetingsTest, TheTextMayChangeWhileTheTalkerTalks) {
  tocsin::SimReader<Greetings> heard(bus_);
  Talker talker(talker_context_, {"good morning", 1});
  bus_.add(talker);
  talker.post([&] { talker.set_parameters({"good evening", 1}); });
  EXPECT_EQ(heard.take().back().text(), "good morning");
  bus_.run_for(tocsin::seconds(1));
  EXPECT_EQ(heard.take().back().text(), "good evening");
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

TEST_F(GreetingsTest, AListenerThatComesLateHearsNothingOld) {
  Talker talker(talker_context_, {"hello", 1});
  bus_.add(talker);
  bus_.run_for(tocsin::seconds(3.5));
  Listener listener(listener_context_, {});
  bus_.add(listener);
  ::testing::internal::CaptureStderr();
  bus_.run_for(tocsin::Duration::zero());
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST_F(GreetingsTest, APeriodIsFromAHundredthOfASecondToAMinute) {
  const auto load = [](const char* text) {
    tocsin::YamlSources sources;
    return tocsin::load_parameters<Talker::Params>(sources.parse(text, "test"), "talker", sources);
  };
  EXPECT_EQ(load("{period_s: 0.01}").period_s, 0.01);
  EXPECT_EQ(load("{period_s: 60, text: \"\"}").text, "");
  EXPECT_THROW(load("{period_s: 0.009}"), tocsin::ConfigError);
  EXPECT_THROW(load("{period_s: 60.1}"), tocsin::ConfigError);
  EXPECT_THROW(load("{text: [a]}"), tocsin::ConfigError);
}

}  // namespace
}  // namespace example
