// SPDX-License-Identifier: Apache-2.0
#include "strangers.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tocsin_idl/topics.hpp"

namespace tocsin::simulation {
namespace {

radio::ChannelParams lossless() {
  radio::ChannelParams params;
  params.mode = "bernoulli";
  return params;
}

/// Keeps what was written to a topic of the host.
template <class Topic>
class Reader : private Receiver {
 public:
  explicit Reader(SimProcess& process)
      : subscription_(
            process.subscribe({Topic::info, &type_info<typename Topic::Message>()}, *this)) {}
  std::vector<typename Topic::Message> take() { return std::exchange(got_, {}); }

 private:
  void receive(const Sample& sample) override {
    got_.push_back(*static_cast<const typename Topic::Message*>(sample.message.get()));
  }
  std::vector<typename Topic::Message> got_;
  std::unique_ptr<Subscription> subscription_;
};

class StrangersTest : public ::testing::Test {
 protected:
  void report(const char* asked, const char* vehicle) {
    auto message = std::make_shared<topic::EmergencyStopState::Message>();
    message->asked(asked);
    message->vehicle(vehicle);
    ASSERT_EQ(state_->write(message), Status::ok);
  }
  std::vector<bool> requests() {
    std::vector<bool> all;
    for (const auto& request : requests_.take()) all.push_back(request.data());
    return all;
  }

  Core core_;
  RadioLink link_{core_, lossless(), {{}, 1, 1}};
  Network network_{core_, link_, QosProfiles(TOCSIN_REPOSITORY "/config/qos.yaml")};
  SimHost host_{network_, "gcs", Role::gcs, TOCSIN_REPOSITORY "/config/traffic.yaml"};
  SimProcess& station_ = host_.add_process("station");
  std::unique_ptr<Publication> state_ = station_.advertise(
      {topic::EmergencyStopState::info, &type_info<topic::EmergencyStopState::Message>()});
  Reader<topic::EmergencyStopRequest> requests_{station_};
  Reader<topic::CmdVel> velocities_{station_};
};

using Asked = std::vector<bool>;

TEST_F(StrangersTest, APersonAsksAgainUntilTheVehicleStands) {
  Person sut(host_.add_process("person"));
  EXPECT_EQ(requests(), Asked{});
  sut.press();
  sut.ask();
  EXPECT_EQ(requests(), (Asked{true, true}));
  report("on", "may_drive");
  sut.ask();
  EXPECT_EQ(requests(), Asked{true});
  report("on", "stands");
  sut.ask();
  EXPECT_EQ(requests(), Asked{});
}

TEST_F(StrangersTest, APersonReleasesUntilTheVehicleMayDrive) {
  Person sut(host_.add_process("person"));
  sut.press();
  report("on", "stands");
  sut.release();
  EXPECT_EQ(requests(), (Asked{true, false}));
  report("never", "may_drive");
  sut.ask();
  EXPECT_EQ(requests(), Asked{false}) << "the station was restarted and knows nothing";
  report("off", "may_drive");
  sut.ask();
  EXPECT_EQ(requests(), Asked{});
}

TEST_F(StrangersTest, APersonHoldsUntilTheLastOfSeveralStopsIsOver) {
  Person sut(host_.add_process("person"));
  sut.press();
  sut.press();
  sut.release();
  EXPECT_EQ(requests(), (Asked{true, true, true}));
  sut.release();
  EXPECT_EQ(requests(), Asked{false});
}

TEST_F(StrangersTest, ARogueDrivesTheBaseWithoutBeingAsked) {
  Rogue sut;
  sut.begin(host_.add_process("rogue"));
  sut.drive();
  sut.drive();
  sut.end();
  const auto driven = velocities_.take();
  ASSERT_EQ(driven.size(), 2U);
  EXPECT_EQ(driven[0].linear().x(), 0.5);
}

}  // namespace
}  // namespace tocsin::simulation
