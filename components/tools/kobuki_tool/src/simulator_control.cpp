// SPDX-License-Identifier: Apache-2.0
#include "simulator_control.hpp"

#include <nlohmann/json.hpp>

namespace tocsin::kobuki {

std::optional<double> SimulatorControl::state(const std::string& key) {
  const auto answer = ask("get");
  if (!answer) return std::nullopt;
  const auto json = nlohmann::json::parse(*answer, nullptr, false);
  if (!json.is_object() || !json.contains(key) || !json[key].is_number()) return std::nullopt;
  return json[key].get<double>();
}

}  // namespace tocsin::kobuki
