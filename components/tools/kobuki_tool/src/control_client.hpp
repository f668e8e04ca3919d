// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "foundation/datagram_socket.hpp"
#include "simulator_control.hpp"

namespace tocsin::kobuki {

/// Asks the control socket of a running kobuki_simulator.
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
