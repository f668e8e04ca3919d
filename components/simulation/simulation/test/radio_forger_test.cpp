// SPDX-License-Identifier: Apache-2.0
#include "radio_forger.hpp"

#include <gtest/gtest.h>

#include <set>

#include "link_bus_fixture.hpp"

namespace tocsin::simulation {
namespace {

using link_event::LinkSample;

class RadioForgerTest : public LinkBusTest {
 protected:
  RadioForgerTest() {
    connect();
    sut_.begin();
  }
  /// What the vehicle was told of the stop since one looked last.
  std::vector<StopValue> told() {
    std::vector<StopValue> all;
    for (const ReceivedStop& one : up().bus.take_stop_news().values) all.push_back(one.value);
    return all;
  }
  RadioForger sut_{network_, 1};
};

StopValue pressed() {
  StopValue value;
  value.stands = true;
  value.number = 100;
  value.locks = {StopToken{1}};
  return value;
}

TEST_F(RadioForgerTest, SaysNothingInTheNameOfWhomItHasNotHeard) {
  sut_.speak();
  EXPECT_TRUE(told().empty());
}

TEST_F(RadioForgerTest, ReleasesAStopInTheStationsNameWithoutItsKey) {
  down().bus.say_stop(pressed());
  run_for(0.1);
  (void)told();
  bool released = false;
  bool jumped = false;
  for (int i = 0; i < 60; ++i) {
    sut_.speak();
    for (const StopValue& value : told()) {
      released = released || !value.stands;
      jumped = jumped || value.number > 1000;
      EXPECT_TRUE(value.locks.empty() || value.locks == pressed().locks);
    }
  }
  EXPECT_TRUE(released);
  EXPECT_TRUE(jumped);
  sut_.end();
  sut_.speak();
  EXPECT_TRUE(told().empty());
}

TEST_F(RadioForgerTest, SendsWhatItHasJustHeardAgainUnderOtherNumbers) {
  const auto writer = drive_.advertise(endpoint<topic::Location>());
  run_for(1);
  std::set<std::uint64_t> numbers;
  for (int i = 0; i < 40; ++i) {
    (void)writer->write(message<topic::Location>());
    run_for(0.02);
    sut_.speak();
    run_for(0.02);
  }
  for (const LinkSample& one : down().got<LinkSample>()) numbers.insert(one.number);
  EXPECT_GT(down().count<LinkSample>(), 40U);
  EXPECT_EQ(numbers.count(1ULL << 40U), 1U);
}

}  // namespace
}  // namespace tocsin::simulation
