// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/pose.hpp"
#include "geometry/twist.hpp"
#include "session.hpp"
#include "simulator_control.hpp"

namespace tocsin::kobuki {

enum class StepResult { passed, failed, skipped, not_run };

/// The acceptance list of a base: LEDs, sounds, buttons, bumpers, cliffs, wheel drops, gyro, square
/// drive. A person answers and presses; with `control` a simulator does. A step passes only when
/// the base is still heard after it; once the session is over, what is left is not run.
class Acceptance {
 public:
  struct Counts {
    int passed = 0;
    int failed = 0;
    int skipped = 0;
    int not_run = 0;
    /// Nothing failed and nothing is missing that nobody skipped.
    [[nodiscard]] bool good() const { return failed == 0 && not_run == 0; }
  };

  /// `control` may be null. Both must outlive this. The base must have been heard.
  Acceptance(Session& session, SimulatorControl* control) : session_(session), control_(control) {}
  /// Runs the whole list, prints each result, and a summary.
  Counts run();

 private:
  /// A sensor to be touched: a bit of a field of the core sensors.
  struct Touch {
    const char* what;   ///< "press the left bumper"
    const char* field;  ///< of the simulator's `set`
    std::uint8_t CoreSensors::*sensors;
    unsigned bit;
    unsigned others;  ///< bits that this touch must not set
  };
  static const std::vector<Touch>& touches();

  void step(const std::string& name, const std::function<StepResult()>& body);
  [[nodiscard]] StepResult result_of(const std::function<StepResult()>& body);
  [[nodiscard]] std::optional<char> ask(const std::string& question);
  [[nodiscard]] StepResult judge(const std::string& question);
  [[nodiscard]] StepResult permit(const std::string& question);
  [[nodiscard]] StepResult wait_until(const std::function<bool()>& done);
  [[nodiscard]] unsigned sensors(const Touch& touch) const;

  [[nodiscard]] StepResult leds();
  [[nodiscard]] StepResult sounds();
  [[nodiscard]] StepResult touch(const Touch& touch);
  [[nodiscard]] StepResult gyro();
  [[nodiscard]] StepResult square();
  [[nodiscard]] std::optional<geometry::Pose> true_place();
  [[nodiscard]] StepResult drive_until(const geometry::Twist& velocity,
                                       const std::function<bool()>& done);
  [[nodiscard]] StepResult turn_by(double angle_rad);
  [[nodiscard]] StepResult forward_by(double length_m);
  [[nodiscard]] StepResult drive_square();

  Session& session_;
  SimulatorControl* control_;
  Counts counts_;
};

}  // namespace tocsin::kobuki
