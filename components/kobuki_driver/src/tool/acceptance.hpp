// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "control_client.hpp"
#include "session.hpp"

namespace tocsin::kobuki {

enum class Verdict { passed, failed, skipped };

/// The acceptance list of a base: LEDs, sounds, buttons, bumpers, cliffs, wheel drops, gyro, square
/// drive. A person answers and presses; with `control` a simulator does.
class Acceptance {
 public:
  /// `control` may be null. Both must outlive this.
  Acceptance(Session& session, ControlClient* control) : session_(session), control_(control) {}
  /// Runs the whole list, prints each result, and a summary. The number of failures.
  int run();

 private:
  struct Touch {
    const char* what;   ///< "the left bumper"
    const char* set;    ///< the simulator's entry, "bumper=4"
    const char* clear;  ///< "bumper=0"
    bool (*seen)(const CoreSensors& core);
  };
  void report(const std::string& name, Verdict verdict);
  [[nodiscard]] Verdict ask_person(const std::string& question);
  [[nodiscard]] Verdict without_answer();
  [[nodiscard]] Verdict leds();
  [[nodiscard]] Verdict sounds();
  [[nodiscard]] Verdict touch(const Touch& touch);
  [[nodiscard]] Verdict gyro();
  [[nodiscard]] Verdict square();
  bool drive_until(const BodyVelocity& velocity, const std::function<bool()>& done);
  bool turn_by(double angle_rad);
  bool forward_by(double length_m);
  static const std::vector<Touch>& touches();

  Session& session_;
  ControlClient* control_;
  int passed_ = 0;
  int failed_ = 0;
  int skipped_ = 0;
};

}  // namespace tocsin::kobuki
