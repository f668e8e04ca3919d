// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deployment/deployment.hpp"

namespace CLI {
class App;
}

namespace tocsin {

/// The arguments of every command that takes a bringup file.
struct BringupOptions {
  std::string file;
  deployment::Overrides overrides;
  std::optional<int> domain;  ///< in place of the file's

  /// Adds FILE, --set, --without, --host, --seed, --channel, --security, --qos, --traffic and
  /// --domain to a command.
  void declare(CLI::App& app);
  /// After parsing: fills in the installed share folder, and looks for a bare file name there when
  /// it is not in the working folder.
  void locate();
  /// The options that `declare` reads, for a command that is given them on.
  [[nodiscard]] std::vector<std::string> arguments() const;
};

}  // namespace tocsin
