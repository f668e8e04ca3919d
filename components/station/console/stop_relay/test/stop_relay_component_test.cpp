// SPDX-License-Identifier: Apache-2.0
#include "stop_relay/stop_relay_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

struct StopAtTheSite {
  using Message = topic::EmergencyStop::Message;
  static constexpr TopicInfo info{"/uxv1/emergency_stop", "state", Scope::host, Requests::anything};
};
struct RequestAtTheSite {
  using Message = topic::EmergencyStopRequest::Message;
  static constexpr TopicInfo info{"/uxv1/emergency_stop/request", "event", Scope::host,
                                  Requests::anything};
};
struct StateAtTheSite {
  using Message = topic::EmergencyStopState::Message;
  static constexpr TopicInfo info{"/uxv1/emergency_stop/state", "state", Scope::host};
};
using Words = std::vector<bool>;

StopRelayComponent::Params for_vehicle(const std::string& name) {
  StopRelayComponent::Params params;
  params.vehicle = name;
  return params;
}

class StopRelayComponentTest : public ::testing::Test {
 protected:
  StopRelayComponentTest() { bus_.add(sut_); }
  void hear(bool stands) {
    topic::LinkStop::Message message;
    message.stands(stands);
    bus_.publish<topic::LinkStop>(message);
    bus_.run_for(seconds(0.01));
  }
  template <class Reader>
  Words words(Reader& reader, double s = 0) {
    bus_.run_for(seconds(s));
    Words all;
    for (const auto& one : reader.take()) all.push_back(one.data());
    return all;
  }
  SimBus bus_;
  Context context_{bus_, "stop_relay", Role::uxv};
  SimReader<StopAtTheSite> stops_{bus_};
  SimReader<topic::EmergencyStopRequest> releases_{bus_};
  SimReader<topic::SafetyStatus> statuses_{bus_};
  StopRelayComponent sut_{context_, for_vehicle("uxv1")};
};

TEST_F(StopRelayComponentTest, SaysNothingUntilTheOtherStationPresses) {
  hear(false);
  EXPECT_EQ(words(stops_, 1), Words());
}

TEST_F(StopRelayComponentTest, RepeatsAStopOfTheOtherStationAndSaysItsRelease) {
  hear(true);
  EXPECT_EQ(words(stops_), Words{true});
  EXPECT_EQ(words(stops_, 1), Words(5, true));
  hear(true);
  EXPECT_EQ(words(stops_), Words()) << "it is known";
  hear(false);
  EXPECT_EQ(words(stops_), Words{false});
  EXPECT_EQ(words(stops_, 5), Words(9, false)) << "for 2 s";
}

TEST_F(StopRelayComponentTest, AReleaseAtTheSiteEndsWhatAStationHasLeft) {
  RequestAtTheSite::Message request;
  request.data(true);
  bus_.publish<RequestAtTheSite>(request);
  bus_.run_for(seconds(0.1));
  EXPECT_EQ(words(releases_), Words()) << "a press is the site's own";
  request.data(false);
  bus_.publish<RequestAtTheSite>(request);
  bus_.run_for(seconds(0.1));
  EXPECT_EQ(words(releases_), Words{false});
}

TEST_F(StopRelayComponentTest, TellsTheOtherStationWhatTheSiteKnowsOfTheVehicle) {
  const auto told = [this](const std::string& vehicle, const std::vector<std::string>& by) {
    StateAtTheSite::Message state;
    state.vehicle(vehicle);
    state.stopped_by(by);
    bus_.publish<StateAtTheSite>(state);
    bus_.run_for(seconds(0.1));
    return statuses_.take();
  };
  EXPECT_TRUE(told("unheard", {}).empty());
  const auto stands = told("stands", {"station"});
  ASSERT_EQ(stands.size(), 1U);
  EXPECT_TRUE(stands[0].emergency_stop());
  EXPECT_EQ(stands[0].stopped_by(), std::vector<std::string>{"station"});
  const auto drives = told("may_drive", {});
  ASSERT_EQ(drives.size(), 1U);
  EXPECT_FALSE(drives[0].emergency_stop());
}

TEST(StopRelayStart, NeedsAVehicle) {
  SimBus bus;
  Context context(bus, "stop_relay", Role::uxv);
  EXPECT_THROW(StopRelayComponent(context, for_vehicle("")), ConfigError);
  EXPECT_THROW(StopRelayComponent(context, for_vehicle("uxv 1")), ConfigError);
}

}  // namespace
}  // namespace tocsin
