// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "kobuki_driver/kobuki_driver.hpp"

namespace tocsin::kobuki {

/// Levels of diagnostic_msgs/DiagnosticStatus.
enum class Health : std::uint8_t { ok, warn, error, stale };

struct Diagnosis {
  Health level = Health::ok;
  std::string name;
  std::string message;
  std::vector<std::pair<std::string, std::string>> values;
};

/// The state of the base in the ten tasks of kobuki_node and one for the serial line. `last` is the
/// last reading; null before the first. Sensors of a base that is not online are stale.
[[nodiscard]] std::vector<Diagnosis> diagnose(const KobukiDriver& driver, const Reading* last);

}  // namespace tocsin::kobuki
