// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace tocsin::kobuki {

/// The control channel of kobuki_simulator, which does what a person would and tells the truth.
class SimulatorControl {
 public:
  virtual ~SimulatorControl() = default;
  /// The answer to one line; empty when none comes within a second.
  [[nodiscard]] virtual std::optional<std::string> ask(const std::string& line) = 0;
  /// A number of the simulator's state; empty when there is no such entry.
  [[nodiscard]] std::optional<double> state(const std::string& key);
};

}  // namespace tocsin::kobuki
