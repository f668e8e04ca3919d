// SPDX-License-Identifier: Apache-2.0
// The emergency stop's part of a router, on a scripted link.
#include <gmock/gmock.h>

#include <cmath>

#include "foundation/temporary_folder.hpp"
#include "link_router/stop_speaker.hpp"
#include "link_router_fixture.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A router of either role, with a folder for its successor.
class RouterStopTest : public ::testing::Test {
 protected:
  void start(Role role) {
    host_.reset();
    script_.rules = TrafficRules(std::string(TOCSIN_REPOSITORY) + "/config/traffic.yaml", role);
    host_.emplace(script_, role, folder_.path());
    run(0.01);
  }
  void run(double s) { host_->bus.run_for(seconds(s)); }
  /// The other side's router says this.
  void hear(StopValue value, std::uint64_t router = 7) {
    value.number = ++number_;
    script_.stop_news.values.push_back({value, router, "", host_->bus.now()});
    script_.stop_news.packets.push_back({router, host_->bus.now()});
    script_.on_event();
    run(0);
  }
  static StopValue station(bool stands, const StopToken& key = {1}) {
    StopValue value;
    value.role = Role::gcs;
    value.host = "gcs";
    value.stands = stands;
    if (stands) value.locks = {router::lock_of(key)};
    if (stands) value.by = {"station"};
    if (!stands) value.keys = {key};
    return value;
  }
  void say_safety(bool stands) {
    topic::SafetyStatus::Message status;
    status.emergency_stop(stands);
    if (stands) status.stopped_by({"station"});
    host_->bus.publish<topic::SafetyStatus>(status);
    run(0);
  }
  void press(bool on) {
    topic::EmergencyStop::Message word;
    word.data(on);
    host_->bus.publish<topic::EmergencyStop>(word);
    run(0);
  }
  void ask(bool on) {
    topic::EmergencyStopRequest::Message word;
    word.data(on);
    host_->bus.publish<topic::EmergencyStopRequest>(word);
    run(0);
  }
  [[nodiscard]] const StopValue& said() const { return script_.said_stops.back(); }
  [[nodiscard]] topic::LinkStop::Message told() {
    for (const auto& one : host_->told.take()) last_ = one;
    return last_;
  }

  struct Host {
    Host(ScriptedLink& script, Role role, const std::string& folder)
        : bus(script),
          context(Context(bus, "link_router", role).with_run_dir(folder)),
          router(context, {}) {
      bus.add(router);
    }
    RoutedSimBus bus;
    Context context;
    SimReader<topic::LinkStop> told{bus};
    LinkRouterComponent router;
  };
  TemporaryFolder folder_;
  ScriptedLink script_;
  std::optional<Host> host_;
  topic::LinkStop::Message last_;
  std::uint64_t number_ = 0;
};

TEST_F(RouterStopTest, AVehicleTellsItsHostTenTimesASecond) {
  start(Role::uxv);
  hear(station(false));
  (void)told();
  int messages = 0;
  for (int i = 0; i < 100; ++i) {
    run(0.01);
    messages += static_cast<int>(host_->told.take().size());
  }
  EXPECT_GE(messages, 10);
  EXPECT_LE(messages, 11);
}

TEST_F(RouterStopTest, AStopOfAStationStandsOnTheVehicleAtOnceUntilItIsReleased) {
  start(Role::uxv);
  run(1);
  EXPECT_FALSE(told().stands());
  EXPECT_TRUE(std::isnan(told().silence_s()));
  hear(station(true));
  EXPECT_TRUE(told().stands());
  EXPECT_THAT(told().stopped_by(), ElementsAre("station"));
  EXPECT_EQ(told().silence_s(), 0);
  hear(station(false));
  EXPECT_FALSE(told().stands());
}

TEST_F(RouterStopTest, AVehicleThatBeginsSaysNothingUntilItHasHeardAStationOrASecondOfSilence) {
  start(Role::uxv);
  run(0.9);
  EXPECT_TRUE(host_->told.take().empty());
  run(0.2);
  EXPECT_FALSE(host_->told.take().empty());
  start(Role::uxv);
  hear(station(true));
  EXPECT_TRUE(told().stands());
}

TEST_F(RouterStopTest, AVehicleReportsItsLocksAndWhatItsSafetyControllerSays) {
  start(Role::uxv);
  EXPECT_FALSE(said().known);
  hear(station(true));
  say_safety(true);
  EXPECT_TRUE(said().known);
  EXPECT_TRUE(said().stands);
  EXPECT_THAT(said().by, ElementsAre("station"));
  EXPECT_THAT(said().locks, ElementsAre(router::lock_of({1})));
  say_safety(false);
  EXPECT_FALSE(said().stands);
}

TEST_F(RouterStopTest, AStopStandsOverARestartOfTheVehiclesRouter) {
  start(Role::uxv);
  hear(station(true));
  start(Role::uxv);
  EXPECT_TRUE(told().stands());
  hear(station(false));
  EXPECT_FALSE(told().stands());
}

TEST_F(RouterStopTest, RoutersOfBothSidesInOneRunFolderKeepTheirsApart) {
  start(Role::gcs);
  press(true);
  start(Role::uxv);
  EXPECT_FALSE(told().stands()) << "what the station keeps is no lock";
  hear(station(true));
  start(Role::uxv);
  EXPECT_THAT(said().locks, ElementsAre(router::lock_of({1})));
}

TEST_F(RouterStopTest, APersonAtTheVehicleReleasesWhatAStationThatIsGoneHasLeft) {
  start(Role::uxv);
  hear(station(true));
  const auto releases = told().releases();
  ask(false);
  EXPECT_TRUE(told().stands()) << "its station is received";
  run(3);
  ask(true);
  EXPECT_TRUE(told().stands());
  ask(false);
  EXPECT_FALSE(told().stands());
  EXPECT_GT(told().releases(), releases);
}

TEST_F(RouterStopTest, AStationSaysWhatAnybodyOnItsHostPresses) {
  start(Role::gcs);
  EXPECT_EQ(said().role, Role::gcs);
  EXPECT_FALSE(said().stands);
  EXPECT_THAT(said().locks, IsEmpty());
  press(true);
  ASSERT_EQ(said().locks.size(), 1U);
  EXPECT_TRUE(said().stands);
  EXPECT_FALSE(said().by.empty());
  const StopToken lock = said().locks.front();
  press(false);
  EXPECT_FALSE(said().stands);
  ASSERT_EQ(said().keys.size(), 1U);
  EXPECT_EQ(router::lock_of(said().keys.front()), lock);
}

TEST_F(RouterStopTest, AStationsNumbersRiseTenTimesASecondAndOverARestart) {
  start(Role::gcs);
  const std::uint64_t first = said().number;
  const std::size_t before = script_.said_stops.size();
  run(1);
  EXPECT_GE(script_.said_stops.size() - before, 10U);
  EXPECT_LE(script_.said_stops.size() - before, 11U);
  EXPECT_GT(said().number, first);
}

TEST_F(RouterStopTest, ARestartedStationGoesOnPressingUntilItsHostReleases) {
  start(Role::gcs);
  press(true);
  const auto locks = said().locks;
  start(Role::gcs);
  EXPECT_TRUE(said().stands);
  EXPECT_EQ(said().locks, locks);
}

TEST_F(RouterStopTest, AStationTellsItsHostWhatTheVehicleReports) {
  start(Role::gcs);
  StopValue report;
  report.role = Role::uxv;
  report.host = "uxv";
  report.stands = true;
  report.by = {"station"};
  hear(report);
  EXPECT_TRUE(told().stands());
  EXPECT_THAT(told().stopped_by(), ElementsAre("station"));
  run(1.2);
  EXPECT_FALSE(told().stands()) << "an old report says nothing of now";
  EXPECT_GT(told().silence_s(), 1);
}

TEST_F(RouterStopTest, NamesOfTheOtherSideAreShownAsPrintableText) {
  start(Role::uxv);
  StopValue value = station(true);
  value.by = {"a\x1b[2Jb"};
  hear(value);
  ASSERT_EQ(told().stopped_by().size(), 1U);
  EXPECT_EQ(told().stopped_by().front().find('\x1b'), std::string::npos);
}

TEST_F(RouterStopTest, AVehicleSpeaksWithTheFirstOfItsSitesAndWithTheNextWhenThatIsSilent) {
  script_.sites = {"north", "south"};
  start(Role::uxv);
  SimReader<topic::LinkSite> sites(host_->bus);
  EXPECT_THAT(script_.absent, ElementsAre("south"));
  EXPECT_EQ(said().site, "north");
  run(1);
  EXPECT_EQ(sites.take().back().data(), "north");
  StopValue south = station(false);
  south.host = "south";
  for (int i = 0; i < 7; ++i) {
    hear(south);
    run(0.1);
  }
  EXPECT_THAT(script_.absent, ElementsAre("north"));
  EXPECT_EQ(said().site, "south");
  EXPECT_EQ(sites.take().back().data(), "south") << "at once";
}

TEST_F(RouterStopTest, AStopOfEachSiteStandsWhicheverItSpeaksWith) {
  script_.sites = {"gcs", "south"};
  start(Role::uxv);
  hear(station(false));
  StopValue south = station(true, {2});
  south.host = "south";
  hear(south, 8);
  EXPECT_TRUE(told().stands());
  EXPECT_EQ(said().site, "gcs");
}

TEST_F(RouterStopTest, ASiteLetsGoOfAVehicleThatSpeaksWithAnotherAndReportsThatAlone) {
  start(Role::gcs);
  SimReader<topic::LinkState> states(host_->bus);
  SimReader<topic::LinkSite> sites(host_->bus);
  StopValue vehicle;
  vehicle.role = Role::uxv;
  vehicle.host = "uxv1";
  vehicle.site = "south";
  hear(vehicle);
  EXPECT_THAT(script_.absent, ElementsAre("uxv1"));
  EXPECT_EQ(sites.take().back().data(), "south");
  (void)states.take();
  run(3);
  EXPECT_THAT(states.take(), IsEmpty());
  EXPECT_GE(sites.take().size(), 2U);
  run(2);
  EXPECT_THAT(sites.take(), IsEmpty()) << "the vehicle is silent";
  vehicle.site = "here";
  hear(vehicle);
  EXPECT_THAT(script_.absent, IsEmpty());
  run(3);
  EXPECT_EQ(states.take().size(), 3U);
  EXPECT_THAT(sites.take(), IsEmpty()) << "it speaks with this one";
}

TEST_F(RouterStopTest, OnASecuredLinkAVehicleSaysOfItselfAloneWhereItIs) {
  start(Role::gcs);
  StopValue vehicle;
  vehicle.role = Role::uxv;
  vehicle.host = "uxv1";
  const auto say = [&](const char* identity, const char* site, std::uint64_t number) {
    vehicle.site = site;
    vehicle.number = number;
    script_.stop_news.values.push_back({vehicle, 7, identity, host_->bus.now()});
    run(0.2);
  };
  say("CN=/uxv2", "south", 100'000'000);
  EXPECT_THAT(script_.absent, IsEmpty());
  say("CN=/uxv1", "south", 60'000'000);
  EXPECT_THAT(script_.absent, ElementsAre("uxv1"));
  say("CN=/uxv1", "here", 30'000'000);
  EXPECT_THAT(script_.absent, ElementsAre("uxv1")) << "a recording";
}

TEST_F(RouterStopTest, OnASecuredLinkARecordedValueOfASiteIsNoSignOfIt) {
  script_.sites = {"north", "south"};
  start(Role::uxv);
  StopValue value = station(false);
  const auto say = [&](const std::string& site, std::uint64_t number) {
    value.host = site;
    value.number = number;
    script_.stop_news.values.push_back({value, 7, "CN=/" + site, host_->bus.now()});
  };
  say("north", 9'000'000);
  for (std::uint64_t i = 0; i < 12; ++i) {
    say("north", 1'000'000 + i);
    say("south", 1'000'000 + i);
    run(0.1);
  }
  EXPECT_THAT(script_.absent, ElementsAre("north"));
}

TEST_F(RouterStopTest, AValueThatIsOvertakenSaysNothingOfWhereAVehicleIs) {
  start(Role::gcs);
  StopValue vehicle;
  vehicle.role = Role::uxv;
  vehicle.host = "uxv1";
  const auto say = [&](const char* site, std::uint64_t number) {
    vehicle.site = site;
    vehicle.number = number;
    script_.stop_news.values.push_back({vehicle, 7, "", host_->bus.now()});
    run(0.2);
  };
  say("south", 30'000'000);
  say("here", 29'900'000);
  EXPECT_THAT(script_.absent, ElementsAre("uxv1"));
  say("here", 30'100'000);
  EXPECT_THAT(script_.absent, IsEmpty());
  say("south", ~0ULL);
  say("here", 30'200'000);
  EXPECT_THAT(script_.absent, IsEmpty()) << "a forged number counts for once";
}

}  // namespace
}  // namespace tocsin
