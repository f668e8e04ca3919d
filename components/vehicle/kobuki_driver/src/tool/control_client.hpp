// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "simulator_control.hpp"

namespace tocsin::kobuki {

/// Asks the control socket of a running kobuki_simulator.
class ControlClient final : public SimulatorControl {
 public:
  /// Throws EnvironmentError when no socket can be made.
  explicit ControlClient(std::string path);
  ~ControlClient() override;
  ControlClient(const ControlClient&) = delete;
  ControlClient& operator=(const ControlClient&) = delete;

  [[nodiscard]] std::optional<std::string> ask(const std::string& line) override;

 private:
  std::string path_;
  std::string own_path_;
  int socket_;
};

}  // namespace tocsin::kobuki
