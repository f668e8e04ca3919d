// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop/emergency_stop_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "foundation/temporary_folder.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;

class EmergencyStopComponentTest : public ::testing::Test {
 protected:
  EmergencyStopComponentTest() { start(); }
  void start() {
    sut_.reset();
    sut_ = std::make_unique<EmergencyStopComponent>(context_, EmergencyStopComponent::Params{});
    sut_->tick(bus_.now());
  }
  void ask(bool pressed) {
    topic::EmergencyStopRequest::Message message;
    message.data(pressed);
    bus_.publish<topic::EmergencyStopRequest>(message);
    sut_->tick(bus_.now());
  }
  void hear(const std::vector<std::string>& stopped_by) {
    topic::SafetyStatus::Message message;
    message.emergency_stop(!stopped_by.empty());
    message.stopped_by(stopped_by);
    bus_.publish<topic::SafetyStatus>(message);
    sut_->tick(bus_.now());
  }
  void hear_link(const std::vector<std::string>& stopped_by, double silence_s = 0.05) {
    topic::LinkStop::Message message;
    message.stands(!stopped_by.empty());
    message.stopped_by(stopped_by);
    message.silence_s(silence_s);
    bus_.publish<topic::LinkStop>(message);
    sut_->tick(bus_.now());
  }
  /// The words of the next `s` seconds.
  std::vector<bool> sent(double s = 0) {
    for (double passed = 0; passed < s; passed += 0.1) {
      bus_.run_for(seconds(0.1));
      if (sut_->schedule().due() <= bus_.now()) {
        sut_->schedule().begin_tick(bus_.now());
        sut_->tick(bus_.now());
      }
    }
    std::vector<bool> all;
    for (const auto& stop : stops_.take()) all.push_back(stop.data());
    return all;
  }
  topic::EmergencyStopState::Message state() { return states_.take().back(); }

  const TemporaryFolder folder_;
  SimBus bus_;
  Context context_ = Context(bus_, "emergency_stop", Role::gcs).with_run_dir(folder_.path());
  SimReader<topic::EmergencyStop> stops_{bus_};
  SimReader<topic::EmergencyStopState> states_{bus_};
  std::unique_ptr<EmergencyStopComponent> sut_;
};

using Sent = std::vector<bool>;

TEST_F(EmergencyStopComponentTest, SaysNothingUntilItIsAsked) {
  EXPECT_EQ(sent(1), (Sent{}));
  const auto told = state();
  EXPECT_EQ(told.asked(), "never");
  EXPECT_EQ(told.vehicle(), "unheard");
}

TEST_F(EmergencyStopComponentTest, RepeatsAStopAndSaysARelease) {
  ask(true);
  EXPECT_EQ(sent(), (Sent{true}));
  EXPECT_EQ(sent(1), (Sent{true, true, true, true, true}));
  ask(false);
  EXPECT_EQ(sent(), (Sent{false}));
  hear({});
  EXPECT_EQ(sent(1), (Sent{}));
}

TEST_F(EmergencyStopComponentTest, SpeaksForTheStation) {
  struct Nobody : Receiver {
    void receive(const Sample& sample) override { source = sample.source; }
    std::uint64_t source = 0;
  } listener;
  const auto subscription = bus_.subscribe(
      {topic::EmergencyStop::info, &type_info<topic::EmergencyStop::Message>()}, listener);
  ask(true);
  EXPECT_EQ(subscription->writer(listener.source).value().user_data, topic::EmergencyStop::station);
}

TEST_F(EmergencyStopComponentTest, TellsWhatTheVehicleMakesOfItOnceForEachChange) {
  ask(true);
  EXPECT_EQ(state().asked(), "on");
  hear({"station", "button (7)"});
  const auto told = state();
  EXPECT_EQ(told.vehicle(), "stands");
  EXPECT_THAT(told.stopped_by(), ElementsAre("station", "button (7)"));
  hear({"station", "button (7)"});
  EXPECT_TRUE(states_.take().empty());
  hear({});
  EXPECT_EQ(state().vehicle(), "may_drive");
}

TEST_F(EmergencyStopComponentTest, TellsWhatTheLinkReportsOfTheVehicle) {
  hear_link({"station"}, 3);
  EXPECT_EQ(state().vehicle(), "unheard") << "the value is not fresh";
  hear_link({"station"});
  const auto told = state();
  EXPECT_EQ(told.vehicle(), "stands");
  EXPECT_THAT(told.stopped_by(), ElementsAre("station"));
  hear_link({"station"});
  EXPECT_TRUE(states_.take().empty());
  hear_link({});
  EXPECT_EQ(state().vehicle(), "may_drive");
}

TEST_F(EmergencyStopComponentTest, ALinkThatSaysOtherwiseForASecondOverrulesAnOldStatus) {
  hear({"station"});
  bus_.run_for(seconds(1));
  hear_link({});
  EXPECT_EQ(state().vehicle(), "may_drive");
}

TEST_F(EmergencyStopComponentTest, TheLinkConfirmsARelease) {
  ask(true);
  hear_link({"station"});
  ask(false);
  EXPECT_EQ(sent(0.4).back(), false);
  hear_link({});
  (void)sent();
  EXPECT_EQ(sent(1), (Sent{}));
}

TEST_F(EmergencyStopComponentTest, StaysPressedOverARestart) {
  ask(true);
  start();
  EXPECT_EQ(sent(), (Sent{true, true}));
  EXPECT_EQ(state().asked(), "on");
}

TEST_F(EmergencyStopComponentTest, AReleasedStopStaysReleasedOverARestart) {
  ask(true);
  ask(false);
  (void)sent();
  start();
  EXPECT_EQ(sent(1), (Sent{}));
}

TEST_F(EmergencyStopComponentTest, StaysPressedOverARestartThoughItsFileIsGone) {
  ask(true);
  std::filesystem::remove_all(folder_.path());
  (void)sent();
  start();
  EXPECT_EQ(sent(1), (Sent{}));
  hear({"station"});
  EXPECT_EQ(sent(), (Sent{true}));
}

TEST_F(EmergencyStopComponentTest, StartsAfreshInANewLaunch) {
  StateFile file(folder_.path("emergency_stop.request"));
  ASSERT_TRUE(file.save("1 on"));
  start();
  EXPECT_EQ(sent(), (Sent{}));
}

TEST_F(EmergencyStopComponentTest, ADamagedFileReleasesNothing) {
  folder_.write("emergency_stop.request", std::to_string(::getppid()) + " on");
  start();
  EXPECT_EQ(sent(), (Sent{}));
}

}  // namespace
}  // namespace tocsin
