// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop_input/emergency_stop_input.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <optional>

#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Writer = SimWriter<topic::EmergencyStop>;

/// A component that does nothing but listen.
class Listener : public Component {
 public:
  using Component::Component;
  void tick(Time) override {}
  EmergencyStopInput stop{*this};
};

class EmergencyStopInputTest : public ::testing::Test {
 protected:
  bool stands() {
    (void)sut_.stop.take();
    return sut_.stop.stands();
  }
  static void say(Writer& writer, bool pressed) {
    topic::EmergencyStop::Message word;
    word.data(pressed);
    EXPECT_EQ(writer.write(word), Status::ok);
  }
  std::unique_ptr<Writer> make_station() {
    return std::make_unique<Writer>(bus_, topic::EmergencyStop::station);
  }

  SimBus bus_;
  Context context_{bus_, "listener", Role::uxv};
  Listener sut_{context_};
};

TEST_F(EmergencyStopInputTest, StandsByTheWordOfAnybody) {
  EXPECT_FALSE(stands());
  Writer anybody(bus_);
  say(anybody, true);
  EXPECT_TRUE(stands());
}

TEST_F(EmergencyStopInputTest, TellsWhetherAnythingCame) {
  EXPECT_FALSE(sut_.stop.take());
  Writer anybody(bus_);
  say(anybody, false);
  EXPECT_TRUE(sut_.stop.take());
  EXPECT_FALSE(sut_.stop.take());
}

TEST_F(EmergencyStopInputTest, StandsUntilEachWriterHasReleasedItself) {
  Writer one(bus_);
  Writer two(bus_);
  say(one, true);
  say(two, true);
  say(one, false);
  EXPECT_TRUE(stands());
  say(two, false);
  EXPECT_FALSE(stands());
}

TEST_F(EmergencyStopInputTest, TheFalseOfAnotherReleasesNothing) {
  const auto station = make_station();
  Writer other(bus_);
  say(*station, true);
  for (int i = 0; i < 3; ++i) say(other, false);
  EXPECT_TRUE(stands());
}

TEST_F(EmergencyStopInputTest, TheStationIsOneWriterWhicheverProcessSpeaks) {
  auto first = make_station();
  say(*first, true);
  EXPECT_TRUE(stands());
  first.reset();
  const auto second = make_station();
  EXPECT_TRUE(stands());
  EXPECT_THAT(sut_.stop.stopped_by(), ElementsAre("station"));
  say(*second, false);
  EXPECT_FALSE(stands());
}

TEST_F(EmergencyStopInputTest, AStopOfTheDeadStaysUntilTheStationReleases) {
  std::optional<Writer> dead(bus_);
  Writer alive(bus_);
  say(*dead, true);
  say(alive, true);
  EXPECT_TRUE(stands());
  dead.reset();
  EXPECT_TRUE(stands());
  const auto station = make_station();
  say(*station, false);
  EXPECT_TRUE(stands());  // by the one that lives
  EXPECT_THAT(sut_.stop.stopped_by(), ElementsAre(HasSubstr("simulated (")));
  say(alive, false);
  EXPECT_FALSE(stands());
}

TEST_F(EmergencyStopInputTest, AWriterThatHadGoneBeforeItsWordWasTakenStops) {
  {
    Writer brief(bus_);
    say(brief, true);
  }
  EXPECT_TRUE(stands());
  EXPECT_THAT(sut_.stop.stopped_by(), ElementsAre(HasSubstr("an unknown writer (")));
  const auto station = make_station();
  say(*station, false);
  EXPECT_FALSE(stands());
}

TEST_F(EmergencyStopInputTest, AWriterThatHasGoneKeepsTheNameThatItHadWhenItPressed) {
  std::optional<Writer> brief(bus_);
  say(*brief, true);
  EXPECT_TRUE(stands());
  say(*brief, true);
  brief.reset();
  EXPECT_TRUE(stands());  // the second word is taken when nobody knows whose it is
  EXPECT_THAT(sut_.stop.stopped_by(), ElementsAre(HasSubstr("simulated (")));
}

TEST_F(EmergencyStopInputTest, WhatStoodBeforeARestartStands) {
  sut_.stop.restore({true, false});
  EXPECT_TRUE(stands());
  const auto station = make_station();
  say(*station, false);
  EXPECT_FALSE(stands());
}

}  // namespace
}  // namespace tocsin
