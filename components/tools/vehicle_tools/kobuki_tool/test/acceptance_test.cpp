// SPDX-License-Identifier: Apache-2.0
#include "acceptance.hpp"

#include <gmock/gmock.h>

#include "session_rig.hpp"

namespace tocsin::kobuki {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The list on a simulated base that presses by itself.
struct AcceptanceList : ::testing::Test {
  Acceptance::Counts run() {
    const auto session = rig->open();
    EXPECT_TRUE(session->hears_base());
    ::testing::internal::CaptureStdout();
    const Acceptance::Counts counts = Acceptance(*session, control).run();
    out = ::testing::internal::GetCapturedStdout();
    return counts;
  }
  void on(const ModelParams& base) {
    rig = std::make_unique<SessionRig>(base);
    control = rig.get();
  }
  /// The line of a step.
  [[nodiscard]] std::string line_of(const std::string& step) const {
    const std::size_t at = out.find("\n" + step + " ");
    return at == std::string::npos ? "" : out.substr(at + 1, out.find('\n', at + 1) - at - 1);
  }

  std::unique_ptr<SessionRig> rig = std::make_unique<SessionRig>();
  SimulatorControl* control = rig.get();
  std::string out;
};

TEST_F(AcceptanceList, PassesOnAGoodBase) {
  const Acceptance::Counts counts = run();
  EXPECT_TRUE(counts.good()) << out;
  EXPECT_EQ(counts.passed, 15);
  EXPECT_THAT(out, HasSubstr("15 passed, 0 failed, 0 skipped\n"));
}

TEST_F(AcceptanceList, IsNotGoodWheneverTheCableIsPulled) {
  (void)run();
  const double whole_s = rig->elapsed_s();
  for (double at_s = 0.1; at_s < whole_s; at_s += at_s < 4 ? 0.08 : 1.7) {  // touches are short
    on({});
    rig->unplug_at = SessionRig::start + seconds(at_s);
    const Acceptance::Counts counts = run();
    EXPECT_EQ(counts.failed, 1) << at_s << '\n' << out;
    EXPECT_EQ(counts.passed + counts.failed + counts.not_run, 15);
    EXPECT_FALSE(counts.good());
    EXPECT_LT(rig->elapsed_s(), at_s + 0.1) << "it goes on without a base";
  }
}

TEST_F(AcceptanceList, IsNotGoodWheneverTheFramesStop) {
  (void)run();
  const double whole_s = rig->elapsed_s();
  for (double at_s = 0.1; at_s < whole_s; at_s += at_s < 4 ? 0.2 : 2.9) {
    on({});
    rig->silent_at = SessionRig::start + seconds(at_s);
    const Acceptance::Counts counts = run();
    EXPECT_GE(counts.failed, 1) << at_s << '\n' << out;
    EXPECT_FALSE(counts.good());
    EXPECT_LT(rig->elapsed_s(), at_s + 3.2);
  }
}

TEST_F(AcceptanceList, IsNotGoodWhenTheBaseGetsNothing) {
  rig->deaf_at = SessionRig::start;
  const Acceptance::Counts counts = run();
  EXPECT_EQ(counts.failed, 4) << out;  // LEDs, sounds, gyro, square
}

TEST_F(AcceptanceList, IsNotGoodWhenTheUserEndsIt) {
  rig->interrupt_at = SessionRig::start + seconds(5);
  const Acceptance::Counts counts = run();
  EXPECT_EQ(counts.failed, 0);
  EXPECT_GT(counts.not_run, 0);
  EXPECT_FALSE(counts.good());
  EXPECT_THAT(out, HasSubstr(std::to_string(counts.not_run) + " not run\n"));
}

TEST_F(AcceptanceList, FailsEachTouchThatIsNotReported) {
  for (const char* broken :
       {"buttons=1", "buttons=2", "buttons=4", "bumper=4", "bumper=2", "bumper=1", "cliff=4",
        "cliff=2", "cliff=1", "wheel_drop=2", "wheel_drop=1"}) {
    on({});
    rig->refuses = broken;
    EXPECT_EQ(run().failed, 1) << broken << '\n' << out;
  }
}

TEST_F(AcceptanceList, FailsASensorThatIsReportedBeforeItIsTouched) {
  const auto session = rig->open();
  rig->model().inputs().cliff = left_bit | centre_bit | right_bit;
  (void)run();
  EXPECT_THAT(line_of("lift the left cliff sensor"), HasSubstr("FAILED")) << out;
  EXPECT_THAT(line_of("press the left bumper"), HasSubstr("passed")) << out;
}

TEST_F(AcceptanceList, FailsASensorThatIsReportedWithAnother) {
  class Crossed final : public SimulatorControl {
   public:
    explicit Crossed(SessionRig& rig) : rig_(rig) {}
    std::optional<std::string> ask(const std::string& line) override {
      return rig_.ask(line == "set bumper=4" ? "set bumper=5" : line);
    }

   private:
    SessionRig& rig_;
  } crossed(*rig);
  control = &crossed;
  EXPECT_EQ(run().failed, 1);
  EXPECT_THAT(line_of("press the left bumper"), HasSubstr("FAILED")) << out;
}

TEST_F(AcceptanceList, FailsAGyroThatTurnsAnotherNumberOfTurns) {
  ModelParams base;
  base.gyro_scale = 0.9;
  on(base);
  (void)run();
  EXPECT_THAT(line_of("gyro against wheels, one turn"), HasSubstr("FAILED")) << out;
}

TEST_F(AcceptanceList, FailsASquareThatDoesNotCloseInTruth) {
  ModelParams base;
  base.gyro_scale = 1.08;  // odometry believes it
  on(base);
  (void)run();
  EXPECT_THAT(out, HasSubstr("within 0.0")) << out;
  EXPECT_THAT(line_of("square of 0.5 m"), HasSubstr("FAILED")) << out;
}

TEST_F(AcceptanceList, FailsWhenThePersonSaysNoOrNothing) {
  control = nullptr;
  const double leds_s = 8 * 0.6;
  rig->keys.emplace(SessionRig::start + seconds(leds_s + 1), 'n');
  const Acceptance::Counts counts = run();
  EXPECT_THAT(line_of("LEDs"), HasSubstr("FAILED")) << out;
  EXPECT_EQ(counts.failed, 15) << out;
  EXPECT_THAT(out, HasSubstr("no answer"));
}

TEST_F(AcceptanceList, SkipsWhatThePersonSkips) {
  control = nullptr;
  for (int i = 0; i < 300; ++i) rig->keys.emplace(SessionRig::start + seconds(6 + i), 's');
  const Acceptance::Counts counts = run();
  EXPECT_EQ(counts.skipped, 15) << out;
}

TEST_F(AcceptanceList, StopsADriveWhenThePersonSkipsIt) {
  control = nullptr;
  for (int i = 0; i < 60; ++i) rig->keys.emplace(SessionRig::start + seconds(6 + i), 's');
  rig->keys.emplace(SessionRig::start + seconds(6.5), 'y');
  (void)run();
  EXPECT_NEAR(rig->model().velocity().linear_mps, 0, 1e-9);
  EXPECT_NEAR(rig->model().velocity().angular_rad_s, 0, 1e-9);
}

}  // namespace
}  // namespace tocsin::kobuki
