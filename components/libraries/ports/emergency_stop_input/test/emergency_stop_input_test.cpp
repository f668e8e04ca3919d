// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop_input/emergency_stop_input.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
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
    (void)sut_.stop.take(bus_.now());
    return sut_.stop.stands();
  }
  static void say(Writer& writer, bool pressed) {
    topic::EmergencyStop::Message word;
    word.data(pressed);
    EXPECT_EQ(writer.write(word), Status::ok);
  }
  void hear_link(bool stands, std::uint64_t releases = 0,
                 const std::vector<std::string>& by = {"station"}) {
    topic::LinkStop::Message message;
    message.stands(stands);
    if (stands) message.stopped_by(by);
    message.releases(releases);
    bus_.publish<topic::LinkStop>(message);
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

TEST_F(EmergencyStopInputTest, TellsWhetherWhatStandsHasChanged) {
  EXPECT_FALSE(sut_.stop.take(bus_.now()));
  Writer anybody(bus_);
  say(anybody, false);
  EXPECT_FALSE(sut_.stop.take(bus_.now()));
  say(anybody, true);
  EXPECT_TRUE(sut_.stop.take(bus_.now()));
  say(anybody, true);
  EXPECT_FALSE(sut_.stop.take(bus_.now()));
  hear_link(true);
  EXPECT_TRUE(sut_.stop.take(bus_.now())) << "another stop";
  hear_link(true);
  EXPECT_FALSE(sut_.stop.take(bus_.now()));
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
  sut_.stop.restore({{true, false}, {}}, bus_.now());
  EXPECT_TRUE(sut_.stop.stands());
  EXPECT_TRUE(stands());
  const auto station = make_station();
  say(*station, false);
  EXPECT_FALSE(stands());
}

TEST_F(EmergencyStopInputTest, StandsWhileTheLinkSaysSo) {
  hear_link(true, 0, {"station", "console (7)"});
  EXPECT_TRUE(stands());
  EXPECT_THAT(sut_.stop.stopped_by(), ElementsAre("station", "console (7)"));
  hear_link(false);
  EXPECT_FALSE(stands());
  EXPECT_THAT(sut_.stop.stopped_by(), IsEmpty());
}

TEST_F(EmergencyStopInputTest, ALocalFalseDoesNotReleaseTheStopOfTheLink) {
  hear_link(true);
  const auto station = make_station();
  say(*station, false);
  EXPECT_TRUE(stands());
}

TEST_F(EmergencyStopInputTest, TheLinkDoesNotReleaseTheStopOfALocalWriter) {
  Writer button(bus_);
  say(button, true);
  hear_link(true);
  hear_link(false, 1);
  EXPECT_TRUE(stands());
  EXPECT_THAT(sut_.stop.stopped_by(), ElementsAre(HasSubstr("simulated (")));
}

TEST_F(EmergencyStopInputTest, NamesTheStationFirstAndOnce) {
  Writer button(bus_);
  say(button, true);
  const auto station = make_station();
  say(*station, true);
  hear_link(true);
  EXPECT_TRUE(stands());
  EXPECT_THAT(sut_.stop.stopped_by(), ElementsAre("station", HasSubstr("simulated (")));
}

TEST_F(EmergencyStopInputTest, AReleaseByPeopleOverTheLinkEndsWhatTheDeadHaveLeft) {
  {
    Writer dead(bus_);
    say(dead, true);
  }
  hear_link(false, 4);
  EXPECT_TRUE(stands());
  hear_link(false, 4);
  EXPECT_TRUE(stands());
  hear_link(false, 5);
  EXPECT_FALSE(stands());
}

TEST_F(EmergencyStopInputTest, AsksToBeWokenWhenTheRouterFallsSilent) {
  EXPECT_EQ(sut_.stop.deadline(), never);
  hear_link(false);
  EXPECT_FALSE(stands());
  EXPECT_EQ(sut_.stop.deadline(), bus_.now() + LinkStopView::silent_after);
  bus_.run_until(sut_.stop.deadline() - Duration{1});
  EXPECT_FALSE(sut_.stop.take(bus_.now()));
  bus_.run_until(sut_.stop.deadline());
  EXPECT_TRUE(sut_.stop.take(bus_.now()));
  EXPECT_TRUE(sut_.stop.stands());
  EXPECT_THAT(sut_.stop.stopped_by(), ElementsAre("link_router is silent"));
  EXPECT_EQ(sut_.stop.deadline(), never);
  hear_link(false);
  EXPECT_FALSE(stands());
}

TEST_F(EmergencyStopInputTest, AStopOfTheLinkStandsOverARestartUntilTheRouterIsReceived) {
  hear_link(true);
  EXPECT_TRUE(stands());
  Listener successor(context_);
  successor.stop.restore(sut_.stop.memory(), bus_.now());
  EXPECT_TRUE(successor.stop.stands());
  hear_link(false);
  EXPECT_TRUE(successor.stop.take(bus_.now()));
  EXPECT_FALSE(successor.stop.stands());
}

TEST_F(EmergencyStopInputTest, ShowsNamesFromTheLinkAsPrintableTextOnly) {
  hear_link(true, 0, {"a\x1b[2Jb", std::string(100, 'x')});
  EXPECT_TRUE(stands());
  for (const std::string& name : sut_.stop.stopped_by()) {
    EXPECT_EQ(name.find('\x1b'), std::string::npos);
    EXPECT_LT(name.size(), 80U);
  }
}

}  // namespace
}  // namespace tocsin
