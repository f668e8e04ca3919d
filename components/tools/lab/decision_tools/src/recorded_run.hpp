// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "decision/qni.hpp"
#include "foundation/role.hpp"

namespace YAML {
class Node;
}

namespace tocsin::tools {

/// The parameters that the transmission_controller of a recorded run had.
struct ControllerParameters {
  std::string file;                          ///< the run's deployment.yaml
  std::vector<Role> roles;                   ///< whose: of one, or of all that decide alike
  std::shared_ptr<const YAML::Node> values;  ///< a map; what is not in it had its default
  /// How the run computed its quality index. Throws ConfigError for a value that is not allowed.
  [[nodiscard]] decision::QniParams quality() const;
};

/// Those of the run that a file was recorded in, from deployment.yaml in its folder, or the one
/// above a folder uxv or gcs; empty when neither is there. Without `role` any, if all decide alike.
/// Throws ConfigError when the file is bad, has no such controller, or more than one to
/// choose from.
[[nodiscard]] std::optional<ControllerParameters> controller_of_run(const std::string& recording,
                                                                    std::optional<Role> role);

/// "uxv and gcs".
[[nodiscard]] std::string joined_roles(const std::vector<Role>& roles);

}  // namespace tocsin::tools
