// SPDX-License-Identifier: Apache-2.0
#include "teleop_gamepad/teleop_gamepad_component.hpp"

#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

#include <deque>

#include "teleop_fixture.hpp"

namespace tocsin {
namespace {

/// What the component and its test share of a pad.
struct Pad {
  bool plugged = true;
  std::deque<PadEvent> events;
};

class FakePad final : public GamepadDevice {
 public:
  explicit FakePad(Pad& pad) : pad_(pad) {}
  [[nodiscard]] std::string name() const override { return "fake"; }
  [[nodiscard]] PadAxes axes() const override { return {{ABS_X, {0, 255}}, {ABS_Y, {0, 255}}}; }
  [[nodiscard]] Read read(PadEvent& event) override {
    if (!pad_.plugged) return Read::lost;
    if (pad_.events.empty()) return Read::nothing;
    event = pad_.events.front();
    pad_.events.pop_front();
    return Read::event;
  }

 private:
  Pad& pad_;
};

/// A computer with that pad, while it is plugged.
struct WithPad {
  WithPad() {
    computer_.devices.add<GamepadDevice>([this](const std::string& path, const Devices::Readable&) {
      EXPECT_EQ(path, "") << "the first there is";
      return pad_.plugged ? std::make_unique<FakePad>(pad_) : nullptr;
    });
  }
  Pad pad_;
  Computer computer_;
};

class TeleopGamepadComponentTest : protected WithPad, public TeleopFixture<TeleopGamepadComponent> {
 protected:
  TeleopGamepadComponentTest() : TeleopFixture("teleop_gamepad", computer_) {}
  Speeds drive(double s) {
    pad_.events = {{EV_KEY, BTN_TL, 1}, {EV_ABS, ABS_Y, 0}};
    return run(s);
  }
};

TEST_F(TeleopGamepadComponentTest, RepeatsWhatIsHeldAndSendsZeroAtRelease) {
  EXPECT_EQ(drive(0.25), Speeds(3, 0.5));
  pad_.events = {{EV_KEY, BTN_TL, 0}};
  EXPECT_EQ(run(5), Speeds(3, 0));
}

TEST_F(TeleopGamepadComponentTest, SendsZeroWhenThePadIsPulledAndTakesItBack) {
  drive(0.05);
  pad_.plugged = false;
  EXPECT_EQ(run(0), (Speeds{0}));
  run(5);
  pad_.plugged = true;
  run(1.1);
  EXPECT_EQ(drive(0), (Speeds{0.5}));
}

TEST_F(TeleopGamepadComponentTest, TheStartButtonAsksForControlOfWhoDrives) {
  const std::string me = operator_name("", "gamepad");
  pad_.events = {{EV_KEY, BTN_START, 1}, {EV_KEY, BTN_START, 0}};
  run(0);
  EXPECT_TRUE(requests(me).empty()) << "nobody drives";
  report_driver("anna");
  pad_.events = {{EV_KEY, BTN_START, 1}, {EV_KEY, BTN_START, 2}, {EV_KEY, BTN_START, 0}};
  run(0);
  EXPECT_EQ(requests(me), std::vector<std::string>{"ask"});
}

TEST_F(TeleopGamepadComponentTest, LooksForAnAbsentPadOnceASecond) {
  pad_.plugged = false;
  run(0);
  EXPECT_EQ(sut_->schedule().due(), bus_.now() + seconds(1));
}

TEST_F(TeleopGamepadComponentTest, LeavesTheVehicleStandingWhenItEnds) {
  drive(0.05);
  sut_.reset();
  EXPECT_EQ(sent(), (Speeds{0}));
}

}  // namespace
}  // namespace tocsin
