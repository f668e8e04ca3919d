// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace tocsin::kobuki {

/// Asks the control channel of kobuki_simulator.
class ControlClient {
 public:
  /// Throws EnvironmentError when no socket can be made.
  explicit ControlClient(std::string path);
  ~ControlClient();
  ControlClient(const ControlClient&) = delete;
  ControlClient& operator=(const ControlClient&) = delete;

  /// The answer to one line; empty when none comes within a second.
  [[nodiscard]] std::optional<std::string> ask(const std::string& line);
  /// A number of the simulator's state; empty when there is no such entry.
  [[nodiscard]] std::optional<double> state(const std::string& key);

 private:
  std::string path_;
  std::string own_path_;
  int socket_;
};

}  // namespace tocsin::kobuki
