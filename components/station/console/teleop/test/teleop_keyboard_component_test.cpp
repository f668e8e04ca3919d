// SPDX-License-Identifier: Apache-2.0
#include "teleop_keyboard/teleop_keyboard_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "teleop_fixture.hpp"

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
struct WithTerminal {
  WithTerminal() {
    computer_.devices.add<TerminalDevice>([this](const std::string&, const Devices::Readable&) {
      return std::make_unique<FakeTerminal>(typed_);
    });
  }
  Typed typed_;
  Computer computer_;
};

class TeleopKeyboardComponentTest : protected WithTerminal,
                                    public TeleopFixture<TeleopKeyboardComponent> {
 protected:
  TeleopKeyboardComponentTest() : TeleopFixture("teleop_keyboard", computer_) {}
  Speeds type(const std::string& keys, double s = 0) {
    typed_.waiting = keys;
    return run(s);
  }
};

TEST_F(TeleopKeyboardComponentTest, SendsAPressAtOnceAndZeroWhenNoRepeatComes) {
  EXPECT_EQ(type("w", 0.05), (Speeds{0.3}));
  EXPECT_EQ(run(0.6), Speeds(6, 0.3));
  EXPECT_EQ(run(0.06), (Speeds{0}));
  EXPECT_EQ(run(5), (Speeds{0, 0}));
  EXPECT_EQ(sut_->schedule().due(), never);
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
  EXPECT_THAT(typed_.line, HasSubstr("vehicle not received"));
  topic::SafetyStatus::Message status;
  status.emergency_stop(true);
  bus_.publish<topic::SafetyStatus>(status);
  run(0);
  EXPECT_THAT(typed_.line, HasSubstr("EMERGENCY STOP"));
}

TEST_F(TeleopKeyboardComponentTest, AsksForControlAndGivesOrKeepsIt) {
  using Verbs = std::vector<std::string>;
  const std::string me = operator_name("", "keyboard");
  EXPECT_TRUE(type("h").empty());
  EXPECT_TRUE(requests(me).empty()) << "nobody drives";
  report_driver("anna");
  EXPECT_THAT(typed_.line, HasSubstr("anna drives: h asks for control"));
  type("h");
  EXPECT_EQ(requests(me), Verbs{"ask"});
  report_driver(me, "anna");
  EXPECT_THAT(typed_.line, HasSubstr("anna asks for control"));
  type("n");
  type("h");
  EXPECT_EQ(requests(me), (Verbs{"keep", "give"}));
}

TEST_F(TeleopKeyboardComponentTest, TakesControlFromWhoDrives) {
  const std::string me = operator_name("", "keyboard");
  type("H");
  EXPECT_TRUE(requests(me).empty()) << "nobody drives";
  report_driver("anna");
  EXPECT_THAT(typed_.line, HasSubstr("H takes it"));
  EXPECT_TRUE(type("H").empty()) << "no key of a direction";
  EXPECT_EQ(requests(me), std::vector<std::string>{"take"});
  report_driver(me);
  type("H");
  EXPECT_TRUE(requests(me).empty()) << "it has it";
}

TEST_F(TeleopKeyboardComponentTest, LivesWithoutATerminal) {
  const Computer computer;
  Context context = Context(bus_, "teleop_keyboard", Role::gcs).with_computer(computer);
  sut_ = std::make_unique<TeleopKeyboardComponent>(context, TeleopKeyboardComponent::Params{});
  EXPECT_TRUE(run(1).empty());
  sut_.reset();
}

}  // namespace
}  // namespace tocsin
