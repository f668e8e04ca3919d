// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop/emergency_stop_component.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

class EmergencyStopComponentTest : public ::testing::Test {
 protected:
  EmergencyStopComponentTest() {
    std::filesystem::create_directories(folder_);
    start();
  }
  ~EmergencyStopComponentTest() override { std::filesystem::remove_all(folder_); }
  void start() {
    sut_ = std::make_unique<EmergencyStopComponent>(context_, EmergencyStopComponent::Params{});
    sut_->tick(bus_.now());
  }
  void ask(bool pressed) {
    topic::EmergencyStopRequest::Message message;
    message.data(pressed);
    bus_.publish<topic::EmergencyStopRequest>(message);
    sut_->tick(bus_.now());
  }
  std::vector<bool> sent() {
    std::vector<bool> all;
    for (const auto& stop : stops_.take()) all.push_back(stop.data());
    return all;
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("tocsin_estop_" + std::to_string(::getpid()));
  SimBus bus_;
  Context context_{bus_, "emergency_stop", "gcs", folder_.string()};
  SimReader<topic::EmergencyStop> stops_{bus_};
  std::unique_ptr<EmergencyStopComponent> sut_;
};

using Sent = std::vector<bool>;

TEST_F(EmergencyStopComponentTest, SaysNothingUntilItIsAsked) { EXPECT_EQ(sent(), (Sent{})); }

TEST_F(EmergencyStopComponentTest, SendsEachChangeOnce) {
  ask(true);
  ask(true);
  EXPECT_EQ(sent(), (Sent{true}));
  ask(false);
  EXPECT_EQ(sent(), (Sent{false}));
}

TEST_F(EmergencyStopComponentTest, SendsAReleaseThoughItKnowsOfNoPress) {
  ask(false);
  EXPECT_EQ(sent(), (Sent{false}));
}

TEST_F(EmergencyStopComponentTest, StaysPressedOverARestart) {
  ask(true);
  sent();
  start();
  EXPECT_EQ(sent(), (Sent{true}));
}

TEST_F(EmergencyStopComponentTest, StartsAfreshInANewLaunch) {
  std::ofstream(folder_ / "emergency_stop.request") << "1 on\n";
  start();
  EXPECT_EQ(sent(), (Sent{}));
}

TEST_F(EmergencyStopComponentTest, ADamagedFileReleasesNothing) {
  std::ofstream(folder_ / "emergency_stop.request") << ::getppid() << " of";
  start();
  EXPECT_EQ(sent(), (Sent{}));
}

}  // namespace
}  // namespace tocsin
