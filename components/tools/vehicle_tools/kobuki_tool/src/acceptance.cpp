// SPDX-License-Identifier: Apache-2.0
#include "acceptance.hpp"

#include <cmath>
#include <cstdio>

#include "geometry/pose.hpp"

namespace tocsin::kobuki {
namespace {

constexpr Duration patience = std::chrono::seconds(20);
constexpr double side_m = 0.5;
constexpr double greatest_gap_m = 0.15;

double distance_m(const geometry::Pose& a, const geometry::Pose& b) {
  return distance(position(a), position(b));
}

/// What the gyro turned since this was made, whole turns counted.
class GyroTurn {
 public:
  explicit GyroTurn(Session& session)
      : session_(session), last_rad_(session.last()->gyro_heading_rad) {
    session_.on_reading([this](const Reading& reading) {
      turned_rad_ += geometry::wrap_angle(reading.gyro_heading_rad - last_rad_);
      last_rad_ = reading.gyro_heading_rad;
    });
  }
  ~GyroTurn() {
    session_.on_reading([](const Reading&) {});
  }
  GyroTurn(const GyroTurn&) = delete;
  GyroTurn& operator=(const GyroTurn&) = delete;
  [[nodiscard]] double turned_rad() const { return turned_rad_; }

 private:
  Session& session_;
  double last_rad_;
  double turned_rad_ = 0;
};

}  // namespace

const std::vector<Acceptance::Touch>& Acceptance::touches() {
  using C = CoreSensors;
  constexpr unsigned left_drop = left_wheel_drop_bit;
  static const std::vector<Touch> all{
      {"press button B0", "buttons", &C::buttons, 1, 6},
      {"press button B1", "buttons", &C::buttons, 2, 5},
      {"press button B2", "buttons", &C::buttons, 4, 3},
      {"press the left bumper", "bumper", &C::bumper, left_bit, right_bit},
      {"press the centre bumper", "bumper", &C::bumper, centre_bit, 0},
      {"press the right bumper", "bumper", &C::bumper, right_bit, left_bit},
      {"lift the left cliff sensor", "cliff", &C::cliff, left_bit, right_bit},
      {"lift the centre cliff sensor", "cliff", &C::cliff, centre_bit, 0},
      {"lift the right cliff sensor", "cliff", &C::cliff, right_bit, left_bit},
      {"let the left wheel hang", "wheel_drop", &C::wheel_drop, left_drop, right_bit},
      {"let the right wheel hang", "wheel_drop", &C::wheel_drop, right_bit, left_drop}};
  return all;
}

Acceptance::Counts Acceptance::run() {
  std::printf("keys: y yes, n no, s skip, Ctrl-C ends. The base will turn and drive at the end.\n");
  step("LEDs", [this] { return leds(); });
  step("sounds", [this] { return sounds(); });
  for (const Touch& one : touches()) step(one.what, [&] { return touch(one); });
  step("gyro against wheels, one turn", [this] { return gyro(); });
  step("square of 0.5 m", [this] { return square(); });
  std::printf("%d passed, %d failed, %d skipped", counts_.passed, counts_.failed, counts_.skipped);
  if (counts_.not_run > 0) std::printf(", %d not run", counts_.not_run);
  std::printf("\n");
  return counts_;
}

void Acceptance::step(const std::string& name, const std::function<StepResult()>& body) {
  const StepResult result = result_of(body);
  static constexpr const char* texts[] = {"passed", "FAILED", "skipped", "not run"};
  std::printf("%-32s %s\n", name.c_str(), texts[static_cast<std::size_t>(result)]);
  std::fflush(stdout);
  counts_.passed += result == StepResult::passed ? 1 : 0;
  counts_.failed += result == StepResult::failed ? 1 : 0;
  counts_.skipped += result == StepResult::skipped ? 1 : 0;
  counts_.not_run += result == StepResult::not_run ? 1 : 0;
}

/// A base that is lost during a step has failed it.
StepResult Acceptance::result_of(const std::function<StepResult()>& body) {
  if (session_.over()) return StepResult::not_run;
  const StepResult result = body();
  if (session_.hears_base()) return result;
  return session_.interrupted() ? StepResult::not_run : StepResult::failed;
}

/// Whether it comes in time, fails to, or is skipped by a key.
StepResult Acceptance::wait_until(const std::function<bool()>& done) {
  const Time end = session_.now() + patience;
  while (!session_.run_until(done, end - session_.now())) {
    const auto key = session_.key();
    if (key == 's') return StepResult::skipped;
    if (!key) return StepResult::failed;
  }
  return StepResult::passed;
}

/// y, n or s; empty when nobody answered.
std::optional<char> Acceptance::ask(const std::string& question) {
  std::printf("%s (y/n/s)\n", question.c_str());
  for (;;) {
    (void)session_.run_until([] { return false; }, patience);
    const auto key = session_.key();
    if (!key) std::printf("no answer\n");
    if (!key || key == 'y' || key == 'n' || key == 's') return key;
  }
}

StepResult Acceptance::judge(const std::string& question) {
  const auto answer = ask(question);
  if (answer == 's') return StepResult::skipped;
  return answer == 'y' ? StepResult::passed : StepResult::failed;
}

StepResult Acceptance::permit(const std::string& question) {
  if (control_ != nullptr) return StepResult::passed;
  const auto answer = ask(question);
  if (!answer) return StepResult::failed;
  return answer == 'y' ? StepResult::passed : StepResult::skipped;
}

StepResult Acceptance::leds() {
  bool all_right = true;
  for (const int led : {1, 2}) {
    for (const unsigned colour : {1U, 2U, 3U, 0U}) {  // red, green, orange, off
      OutputRegister outputs = session_.driver().outputs();
      outputs.set_led(led, (colour & 1U) != 0, (colour & 2U) != 0);
      session_.driver().set_outputs(outputs);
      session_.run_for(std::chrono::milliseconds(control_ == nullptr ? 600 : 200));
      if (control_ != nullptr) all_right &= control_->state("outputs") == outputs.bits;
    }
  }
  if (control_ != nullptr) return all_right ? StepResult::passed : StepResult::failed;
  return judge("LED 1, then LED 2: red, green, orange, off?");
}

StepResult Acceptance::sounds() {
  const double before = control_ != nullptr ? control_->state("sounds").value_or(0) : 0;
  for (int i = 0; i <= static_cast<int>(Tune::cleaning_end); ++i) {
    if (!session_.driver().send_once(static_cast<Tune>(i))) return StepResult::failed;
    session_.run_for(std::chrono::milliseconds(control_ == nullptr ? 1500 : 100));
  }
  if (control_ == nullptr) return judge("seven tunes?");
  return control_->state("sounds") == before + 7 ? StepResult::passed : StepResult::failed;
}

unsigned Acceptance::sensors(const Touch& touch) const {
  return session_.last()->feedback.core.value().*touch.sensors;
}

StepResult Acceptance::touch(const Touch& touch) {
  const auto set = [&](unsigned bits) {
    if (control_ != nullptr)
      (void)control_->ask("set " + std::string(touch.field) + "=" + std::to_string(bits));
  };
  const bool at_rest = (sensors(touch) & touch.bit) == 0;
  if (!at_rest) std::printf("is reported before anybody touches it\n");
  if (control_ == nullptr) std::printf("%s (s skips)\n", touch.what);
  set(touch.bit);
  unsigned seen = 0;
  const auto pressed = [&] { return ((seen |= sensors(touch)) & touch.bit) != 0; };
  StepResult result = wait_until(pressed);
  set(0);
  const auto released = [&] {
    seen |= sensors(touch);
    return (sensors(touch) & touch.bit) == 0;
  };
  if (result == StepResult::passed) result = wait_until(released);
  if (result != StepResult::passed) return result;
  if ((seen & touch.others) != 0) std::printf("another sensor is reported with it\n");
  return at_rest && (seen & touch.others) == 0 ? StepResult::passed : StepResult::failed;
}

StepResult Acceptance::drive_until(const geometry::Twist& velocity,
                                   const std::function<bool()>& done) {
  const Time end = session_.now() + patience;
  StepResult result = StepResult::failed;
  while (result == StepResult::failed && session_.now() < end && !session_.over()) {
    session_.driver().on_velocity(velocity, session_.now());
    if (session_.run_until(done, std::chrono::milliseconds(100))) result = StepResult::passed;
    if (session_.key() == 's') result = StepResult::skipped;
  }
  session_.driver().on_velocity({}, session_.now());
  session_.run_for(std::chrono::milliseconds(600));
  return result;
}

StepResult Acceptance::turn_by(double angle_rad) {
  double turned_rad = 0;
  double last_rad = session_.last()->pose.heading_rad;
  return drive_until({0, 0.6}, [&] {
    const double heading_rad = session_.last()->pose.heading_rad;
    turned_rad += geometry::wrap_angle(heading_rad - last_rad);
    last_rad = heading_rad;
    return turned_rad >= angle_rad - 0.12;  // what it turns on until it stands, at 0.6 rad/s
  });
}

StepResult Acceptance::forward_by(double length_m) {
  const geometry::Pose from = session_.last()->pose;
  return drive_until({0.15, 0},
                     [&] { return distance_m(from, session_.last()->pose) >= length_m - 0.03; });
}

StepResult Acceptance::drive_square() {
  for (int i = 0; i < 4; ++i) {
    const StepResult side = forward_by(side_m);
    if (side != StepResult::passed) return side;
    const StepResult corner = turn_by(pi / 2);
    if (corner != StepResult::passed) return corner;
  }
  return StepResult::passed;
}

/// A gyro or wheels that tell of another number of turns differ by those.
StepResult Acceptance::gyro() {
  const StepResult may = permit("may it turn once on the spot?");
  if (may != StepResult::passed) return may;
  const auto difference_m = [&] {
    const Reading& last = *session_.last();
    return (last.right.angle_rad - last.left.angle_rad) * wheel_radius_m;
  };
  const double before_m = difference_m();
  const GyroTurn by_gyro(session_);
  const StepResult turned = turn_by(2 * pi);
  if (turned != StepResult::passed) return turned;
  const double by_wheels_rad = (difference_m() - before_m) / wheel_separation_m;
  const double apart_rad = by_wheels_rad - by_gyro.turned_rad();
  std::printf("wheels and gyro differ by %.1f deg\n", apart_rad / degree);
  return std::abs(apart_rad) < 10 * degree ? StepResult::passed : StepResult::failed;
}

StepResult Acceptance::square() {
  const StepResult may = permit("is there 1 m of free floor ahead and to the left?");
  if (may != StepResult::passed) return may;
  const auto true_from = true_place();
  const geometry::Pose from = session_.last()->pose;
  const StepResult driven = drive_square();
  if (driven != StepResult::passed) return driven;
  const double gap_m = distance_m(from, session_.last()->pose);
  std::printf("back at the start within %.3f m by odometry\n", gap_m);
  if (gap_m >= greatest_gap_m) return StepResult::failed;
  if (control_ == nullptr) return judge("does it stand where it started, within a hand's breadth?");
  const auto true_to = true_place();
  if (!true_from || !true_to) return StepResult::failed;
  std::printf("within %.3f m in truth\n", distance_m(*true_from, *true_to));
  return distance_m(*true_from, *true_to) < greatest_gap_m ? StepResult::passed
                                                           : StepResult::failed;
}

std::optional<geometry::Pose> Acceptance::true_place() {
  if (control_ == nullptr) return std::nullopt;
  const auto x_m = control_->state("x");
  const auto y_m = control_->state("y");
  if (!x_m || !y_m) return std::nullopt;
  return geometry::Pose{*x_m, *y_m, 0};
}

}  // namespace tocsin::kobuki
