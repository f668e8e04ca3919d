// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "runtime/middleware/host_bus.hpp"

namespace tocsin::map_tool {

/// What `tocsin map save` is asked for.
struct SaveOptions {
  std::string name;
  double wait_s = 10;
  bool overwrite = false;
  HostChoice host;
};

/// Saves the map of a running system as NAME.yaml and NAME.pgm; says so. Throws ConfigError when
/// there is a map of that name, or it cannot be written, EnvironmentError when no map comes.
[[nodiscard]] std::string save(const SaveOptions& options);

/// What `tocsin map continue` is asked for.
struct ContinueOptions {
  std::string name;
  bool by_hand = false;
};

/// Becomes `tocsin launch mapping.yaml`, which goes on with NAME.session. Throws ConfigError when
/// there is none.
[[noreturn]] void go_on(const ContinueOptions& options);

}  // namespace tocsin::map_tool
