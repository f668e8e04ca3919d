// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "stop_site.hpp"

namespace tocsin {

/// What is wrong while it is pressed: begun before each press, and for as long as what it returns
/// lives.
using Trouble = std::function<std::shared_ptr<void>(const StopSite&)>;

struct Condition {
  std::string name;
  Trouble trouble;
  bool lasts = false;  ///< the trouble begins once, and not before each press
  int disk_mib = 0;
};

/// All under which a stop must stop.
[[nodiscard]] std::vector<Condition> conditions();

}  // namespace tocsin
