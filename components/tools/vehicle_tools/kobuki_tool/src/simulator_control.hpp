// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "foundation/datagram_socket.hpp"

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

/// That of a running kobuki_simulator.
class ControlClient final : public SimulatorControl {
 public:
  /// Throws when no socket can be made to be answered at.
  explicit ControlClient(std::string path);
  [[nodiscard]] std::optional<std::string> ask(const std::string& line) override;

 private:
  std::string path_;
  DatagramSocket socket_;
};

}  // namespace tocsin::kobuki
