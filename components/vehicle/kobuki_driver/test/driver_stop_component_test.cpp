// SPDX-License-Identifier: Apache-2.0
/// The emergency stop through the component into the wheels of the model.
#include <optional>

#include "component_rig.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

class DriverStopTest : public KobukiDriverComponentTest {
 protected:
  using Stop = SimWriter<topic::EmergencyStop>;
  void SetUp() override {
    context_.run_dir = folder_.path();
    start();
    drive(1, 0.3);
  }
  static void say(Stop& writer, bool pressed) {
    topic::EmergencyStop::Message message;
    message.data(pressed);
    EXPECT_EQ(writer.write(message), Status::ok);
  }
  /// Drives for so long while the router says this of the stop.
  void drive_with_link(double duration_s, bool stands) {
    for (double passed = 0; passed < duration_s; passed += 0.1) {
      topic::LinkStop::Message message;
      message.stands(stands);
      if (stands) message.stopped_by({"station"});
      bus_.publish<topic::LinkStop>(message);
      drive(0.1, 0.3);
    }
  }
  void restart() {
    sut_.reset();
    start();
  }
  [[nodiscard]] double speed() const { return base_.model.velocity().linear_mps; }
  /// The message of the last diagnostics about the motors.
  std::string motor_state() {
    std::string found;
    for (const auto& message : diagnostics_.take()) {
      for (const auto& status : message.status()) {
        if (status.name() == "kobuki_driver: Motor State") found = status.message();
      }
    }
    return found;
  }

  const TemporaryFolder folder_;
  SimReader<topic::Diagnostics> diagnostics_{bus_};
};

TEST_F(DriverStopTest, HoldsAStopOfThisHostWhoeverPublishesVelocities) {
  EXPECT_GT(speed(), 0.2);
  Stop button(bus_);
  say(button, true);
  drive(1, 0.3);
  EXPECT_EQ(speed(), 0);
  drive(5, 0.3);
  EXPECT_EQ(speed(), 0);
  say(button, false);
  run(0.5);
  EXPECT_EQ(speed(), 0) << "it waits for a new velocity";
  drive(1, 0.3);
  EXPECT_GT(speed(), 0.2);
}

TEST_F(DriverStopTest, HoldsAStopOfTheLink) {
  drive(10, 0.3);
  EXPECT_GT(speed(), 0.2) << "no router was received";
  drive_with_link(1, true);
  EXPECT_EQ(speed(), 0);
  drive_with_link(1, false);
  EXPECT_GT(speed(), 0.2);
}

TEST_F(DriverStopTest, StandsWhenTheRouterFallsSilentAndIsWokenForIt) {
  drive_with_link(0.1, false);
  sut_->schedule().begin_tick(bus_.now());
  sut_->tick(bus_.now());
  EXPECT_LE(sut_->schedule().due(), bus_.now() + LinkStopView::silent_after);
  drive(0.8, 0.3);
  EXPECT_GT(speed(), 0.2);
  drive(1, 0.3);
  EXPECT_EQ(speed(), 0);
  drive_with_link(1, false);
  EXPECT_GT(speed(), 0.2);
}

TEST_F(DriverStopTest, HoldsOverItsRestartThoughItHearsNobody) {
  std::optional<Stop> button(bus_);
  say(*button, true);
  drive(1, 0.3);
  button.reset();
  restart();
  drive(1, 0.3);
  EXPECT_EQ(speed(), 0);
  Stop station(bus_, topic::EmergencyStop::station);
  say(station, false);
  drive(1, 0.3);
  EXPECT_GT(speed(), 0.2);
  restart();
  drive(1, 0.3);
  EXPECT_GT(speed(), 0.2);
}

TEST_F(DriverStopTest, HoldsAStopOfTheLinkOverItsRestartAndExpectsTheRouter) {
  drive_with_link(1, true);
  restart();
  drive(2, 0.3);
  EXPECT_EQ(speed(), 0);
  drive_with_link(1, false);
  EXPECT_GT(speed(), 0.2);
  restart();
  drive(2, 0.3);
  EXPECT_EQ(speed(), 0);
}

TEST_F(DriverStopTest, AStopOfAnotherLaunchIsNotKept) {
  StateFile other(folder_.path("kobuki_driver.stop"));
  sut_.reset();
  ASSERT_TRUE(other.save("1 1 1 1 1"));
  start();
  drive(1, 0.3);
  EXPECT_GT(speed(), 0.2);
}

TEST_F(DriverStopTest, SaysInItsDiagnosticsThatItHolds) {
  run(1.1);
  EXPECT_EQ(motor_state(), "on");
  Stop button(bus_);
  say(button, true);
  run(1.1);
  EXPECT_EQ(motor_state(), "held by the emergency stop: velocities are ignored");
}

}  // namespace
}  // namespace tocsin
