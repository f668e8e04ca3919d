// SPDX-License-Identifier: Apache-2.0
#include "acceptance.hpp"

#include <cmath>
#include <cstdio>

namespace tocsin::kobuki {
namespace {

constexpr Duration patience = std::chrono::seconds(20);
constexpr double side_m = 0.5;

}  // namespace

const std::vector<Acceptance::Touch>& Acceptance::touches() {
  using Core = const CoreSensors&;
  static const std::vector<Touch> all{
      {"press button B0", "buttons=1", "buttons=0", [](Core c) { return (c.buttons & 1U) != 0; }},
      {"press button B1", "buttons=2", "buttons=0", [](Core c) { return (c.buttons & 2U) != 0; }},
      {"press button B2", "buttons=4", "buttons=0", [](Core c) { return (c.buttons & 4U) != 0; }},
      {"press the left bumper", "bumper=4", "bumper=0",
       [](Core c) { return (c.bumper & left_bit) != 0; }},
      {"press the centre bumper", "bumper=2", "bumper=0",
       [](Core c) { return (c.bumper & centre_bit) != 0; }},
      {"press the right bumper", "bumper=1", "bumper=0",
       [](Core c) { return (c.bumper & right_bit) != 0; }},
      {"lift the left cliff sensor", "cliff=4", "cliff=0",
       [](Core c) { return (c.cliff & left_bit) != 0; }},
      {"lift the centre cliff sensor", "cliff=2", "cliff=0",
       [](Core c) { return (c.cliff & centre_bit) != 0; }},
      {"lift the right cliff sensor", "cliff=1", "cliff=0",
       [](Core c) { return (c.cliff & right_bit) != 0; }},
      {"let the left wheel hang", "wheel_drop=2", "wheel_drop=0",
       [](Core c) { return (c.wheel_drop & left_wheel_drop_bit) != 0; }},
      {"let the right wheel hang", "wheel_drop=1", "wheel_drop=0",
       [](Core c) { return (c.wheel_drop & right_bit) != 0; }}};
  return all;
}

int Acceptance::run() {
  std::printf("keys: y yes, n no, s skip, Ctrl-C ends. The base will turn and drive at the end.\n");
  report("LEDs", leds());
  report("sounds", sounds());
  for (const Touch& one : touches()) report(one.what, touch(one));
  report("gyro against wheels, one turn", gyro());
  report("square of 0.5 m", square());
  std::printf("%d passed, %d failed, %d skipped\n", passed_, failed_, skipped_);
  return failed_;
}

void Acceptance::report(const std::string& name, Verdict verdict) {
  static constexpr const char* texts[] = {"passed", "FAILED", "skipped"};
  if (session_.over()) verdict = Verdict::skipped;
  std::printf("%-32s %s\n", name.c_str(), texts[static_cast<std::size_t>(verdict)]);
  std::fflush(stdout);
  passed_ += verdict == Verdict::passed ? 1 : 0;
  failed_ += verdict == Verdict::failed ? 1 : 0;
  skipped_ += verdict == Verdict::skipped ? 1 : 0;
}

/// After a wait that did not end well: the person skipped it, or it failed.
Verdict Acceptance::without_answer() {
  const auto key = session_.key();
  return key == 's' || session_.over() ? Verdict::skipped : Verdict::failed;
}

Verdict Acceptance::ask_person(const std::string& question) {
  std::printf("%s (y/n/s)\n", question.c_str());
  for (;;) {
    (void)session_.run_until([] { return false; }, patience);
    const auto key = session_.key();
    if (!key || key == 's') return Verdict::skipped;
    if (key == 'y') return Verdict::passed;
    if (key == 'n') return Verdict::failed;
  }
}

Verdict Acceptance::leds() {
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
  if (control_ != nullptr) return all_right ? Verdict::passed : Verdict::failed;
  return ask_person("LED 1, then LED 2: red, green, orange, off?");
}

Verdict Acceptance::sounds() {
  const double before = control_ != nullptr ? control_->state("sounds").value_or(0) : 0;
  for (int i = 0; i <= static_cast<int>(Tune::cleaning_end); ++i) {
    if (!session_.driver().send_once(static_cast<Tune>(i))) return Verdict::failed;
    session_.run_for(std::chrono::milliseconds(control_ == nullptr ? 1500 : 100));
  }
  if (control_ == nullptr) return ask_person("seven tunes?");
  return control_->state("sounds") == before + 7 ? Verdict::passed : Verdict::failed;
}

Verdict Acceptance::touch(const Touch& touch) {
  const auto seen = [&] {
    const Reading* last = session_.last();
    return last != nullptr && touch.seen(*last->feedback.core);
  };
  if (control_ != nullptr) {
    (void)control_->ask(std::string("set ") + touch.set);
  } else {
    std::printf("%s (s skips)\n", touch.what);
  }
  const bool pressed = session_.run_until(seen, patience);
  if (control_ != nullptr) (void)control_->ask(std::string("set ") + touch.clear);
  if (!pressed) return without_answer();
  const bool released = session_.run_until([&] { return !seen(); }, patience);
  return released ? Verdict::passed : without_answer();
}

bool Acceptance::drive_until(const BodyVelocity& velocity, const std::function<bool()>& done) {
  const Time end = Session::now() + patience;
  bool there = false;
  while (!there && Session::now() < end && !session_.over()) {
    session_.driver().on_velocity(velocity, Session::now());
    there = session_.run_until(done, std::chrono::milliseconds(100));
  }
  session_.driver().on_velocity({}, Session::now());
  session_.run_for(std::chrono::milliseconds(600));
  return there;
}

bool Acceptance::turn_by(double angle_rad) {
  double turned_rad = 0;
  double last_rad = session_.last()->pose.heading_rad;
  return drive_until({0, 0.6}, [&] {
    const double heading_rad = session_.last()->pose.heading_rad;
    turned_rad += wrap_angle(heading_rad - last_rad);
    last_rad = heading_rad;
    return turned_rad >= angle_rad - 0.12;  // what it turns on until it stands, at 0.6 rad/s
  });
}

bool Acceptance::forward_by(double length_m) {
  const Pose from = session_.last()->pose;
  return drive_until({0.15, 0}, [&] {
    const Pose& at = session_.last()->pose;
    return std::hypot(at.x_m - from.x_m, at.y_m - from.y_m) >= length_m - 0.03;
  });
}

Verdict Acceptance::gyro() {
  if (control_ == nullptr && ask_person("may it turn once on the spot?") != Verdict::passed) {
    return Verdict::skipped;
  }
  const auto difference_m = [&] {
    const Reading& last = *session_.last();
    return (last.right.angle_rad - last.left.angle_rad) * wheel_radius_m;
  };
  const double before_m = difference_m();
  if (!turn_by(2 * pi)) return without_answer();
  const double by_wheels_rad = (difference_m() - before_m) / wheel_separation_m;
  const double apart_rad = wrap_angle(by_wheels_rad - session_.last()->gyro_heading_rad);
  std::printf("wheels and gyro differ by %.1f deg\n", apart_rad / degree_rad);
  return std::abs(apart_rad) < 10 * degree_rad ? Verdict::passed : Verdict::failed;
}

Verdict Acceptance::square() {
  if (control_ == nullptr &&
      ask_person("is there 1 m of free floor ahead and to the left?") != Verdict::passed) {
    return Verdict::skipped;
  }
  const Pose from = session_.last()->pose;
  for (int i = 0; i < 4; ++i) {
    if (!forward_by(side_m) || !turn_by(pi / 2)) return without_answer();
  }
  const Pose& to = session_.last()->pose;
  const double gap_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
  std::printf("back at the start within %.3f m by odometry\n", gap_m);
  return gap_m < 0.15 ? Verdict::passed : Verdict::failed;
}

}  // namespace tocsin::kobuki
