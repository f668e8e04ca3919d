// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "devices/background.hpp"
#include "devices/devices.hpp"

namespace tocsin {

/// What a component has of its computer besides topics. By default it has nothing.
struct Computer {
  Devices devices;
  /// Processes can crash: components keep files, in the folder of the run, for the one after them.
  bool keeps_files = false;
  /// Somebody can look at pictures; where nobody can, only their sizes matter.
  bool has_spectators = false;
  /// Never null.
  std::function<std::unique_ptr<Background>()> open_background = work_at_once;
};

/// This computer; programs may add makers to its devices before they start components. Any thread.
[[nodiscard]] Computer& this_computer();

}  // namespace tocsin
