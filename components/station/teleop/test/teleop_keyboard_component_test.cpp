// SPDX-License-Identifier: Apache-2.0
#include "teleop_keyboard/teleop_keyboard_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/absent_devices.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

/// What the component and its test share of a terminal.
struct Typed {
  std::string waiting;
  bool ended = false;
  std::string line;
};

class FakeTerminal final : public TerminalDevice {
 public:
  explicit FakeTerminal(Typed& typed) : typed_(typed) {}
  [[nodiscard]] std::optional<std::string> read() override {
    if (typed_.ended) return std::nullopt;
    return std::exchange(typed_.waiting, "");
  }
  void print(const std::string& text) override { typed_.line = text; }
  void show(const std::string& line) override { typed_.line = line; }

 private:
  Typed& typed_;
};

/// A computer at whose terminal somebody types.
class TypedDevices final : public AbsentDevices {
 public:
  explicit TypedDevices(Typed& typed) : typed_(typed) {}
  std::unique_ptr<TerminalDevice> open_terminal() override {
    return std::make_unique<FakeTerminal>(typed_);
  }

 private:
  Typed& typed_;
};

class TeleopKeyboardComponentTest : public ::testing::Test {
 protected:
  TeleopKeyboardComponentTest() {
    sut_ = std::make_unique<TeleopKeyboardComponent>(context_, TeleopKeyboardComponent::Params{});
  }
  /// Ticks as the runner would for `s` and returns the speeds that were sent.
  std::vector<double> run(double s) {
    const Time end = bus_.now() + seconds(s);
    for (Time next = bus_.now(); next <= end;) {
      bus_.run_until(next);
      sut_->schedule().begin_tick(next);
      sut_->tick(next);
      next = sut_->schedule().due();
    }
    bus_.run_until(end);
    return sent();
  }
  std::vector<double> sent() {
    std::vector<double> speeds;
    for (const auto& command : commands_.take()) speeds.push_back(command.twist().linear().x());
    return speeds;
  }
  std::vector<double> type(const std::string& keys, double s = 0) {
    typed_.waiting = keys;
    return run(s);
  }

  void tell_driver(const std::string& name, const std::string& asked_by) {
    topic::DriverState::Message state;
    state.driver(name);
    state.asked_by(asked_by);
    bus_.publish<topic::DriverState>(state);
  }

  SimBus bus_;
  Typed typed_;
  TypedDevices devices_{typed_};
  Context context_ = Context(bus_, "teleop_keyboard", Role::gcs).with_devices(devices_);
  SimReader<topic::TeleopCmdVel> commands_{bus_};
  std::unique_ptr<TeleopKeyboardComponent> sut_;
};

using Speeds = std::vector<double>;

TEST_F(TeleopKeyboardComponentTest, SendsNothingWhileNothingIsPressed) {
  EXPECT_TRUE(run(5).empty());
  EXPECT_EQ(sut_->schedule().due(), never);
}

TEST_F(TeleopKeyboardComponentTest, SendsAPressAtOnceAndZeroWhenNoRepeatComes) {
  EXPECT_EQ(type("w", 0.05), (Speeds{0.3}));
  EXPECT_EQ(run(0.6), Speeds(6, 0.3));
  EXPECT_EQ(run(0.06), (Speeds{0}));
  EXPECT_EQ(run(5), (Speeds{0, 0}));
  EXPECT_EQ(sut_->schedule().due(), never);
}

TEST_F(TeleopKeyboardComponentTest, SpaceStopsAtOnce) {
  type("w", 0.05);
  EXPECT_EQ(type(" "), (Speeds{0}));
}

TEST_F(TeleopKeyboardComponentTest, SendsZeroWhenTheTerminalGoes) {
  type("w", 0.05);
  typed_.ended = true;
  EXPECT_EQ(run(0), (Speeds{0}));
}

TEST_F(TeleopKeyboardComponentTest, LeavesTheVehicleStandingWhenItEnds) {
  type("w", 0.05);
  sut_.reset();
  EXPECT_EQ(sent(), (Speeds{0}));
}

TEST_F(TeleopKeyboardComponentTest, StampsEveryCommand) {
  typed_.waiting = "w";
  sut_->tick(bus_.now());
  const auto all = commands_.take();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].header().frame_id(), operator_name("", "keyboard"));
  EXPECT_EQ(all[0].header().stamp().sec(), bus_.wall_ns(bus_.now()) / 1'000'000'000);
}

TEST_F(TeleopKeyboardComponentTest, ShowsSpeedsAndWhatHindersTheVehicle) {
  type("r");
  EXPECT_THAT(typed_.line, HasSubstr("speeds 0.33 m/s"));
  EXPECT_THAT(typed_.line, HasSubstr("vehicle not heard"));
  topic::SafetyStatus::Message status;
  status.emergency_stop(true);
  bus_.publish<topic::SafetyStatus>(status);
  run(0);
  EXPECT_THAT(typed_.line, HasSubstr("EMERGENCY STOP"));
}

TEST_F(TeleopKeyboardComponentTest, AsksForTheWheelAndGivesIt) {
  SimReader<topic::DriverRequest> requests(bus_);
  const std::string me = operator_name("", "keyboard");
  EXPECT_TRUE(type("h").empty());
  EXPECT_TRUE(requests.take().empty()) << "nobody drives";
  tell_driver("anna", "");
  run(0);
  EXPECT_THAT(typed_.line, HasSubstr("anna drives: h asks for the wheel"));
  type("h");
  auto sent = requests.take();
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent[0].verb(), "ask");
  EXPECT_EQ(sent[0].name(), me);
  tell_driver(me, "anna");
  run(0);
  EXPECT_THAT(typed_.line, HasSubstr("anna asks for the wheel"));
  type("n");
  type("h");
  sent = requests.take();
  ASSERT_EQ(sent.size(), 2U);
  EXPECT_EQ(sent[0].verb(), "keep");
  EXPECT_EQ(sent[1].verb(), "give");
}

TEST_F(TeleopKeyboardComponentTest, LivesWithoutATerminal) {
  AbsentDevices devices;
  Context context = Context(bus_, "teleop_keyboard", Role::gcs).with_devices(devices);
  sut_ = std::make_unique<TeleopKeyboardComponent>(context, TeleopKeyboardComponent::Params{});
  EXPECT_TRUE(run(1).empty());
  sut_.reset();
}

}  // namespace
}  // namespace tocsin
