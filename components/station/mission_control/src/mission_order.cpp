// SPDX-License-Identifier: Apache-2.0
#include "mission_control/mission_order.hpp"

#include <cstdint>

#include "foundation/whole_number.hpp"

namespace tocsin {
namespace {

constexpr const char* skip = "skip ";

}  // namespace

std::optional<MissionOrder> mission_order_of(const std::string& words) {
  if (words == "pause") return MissionOrder{MissionOrder::Kind::pause};
  if (words == "resume") return MissionOrder{MissionOrder::Kind::resume};
  if (words.rfind(skip, 0) != 0) return std::nullopt;
  const auto number = whole_number(words.substr(std::string(skip).size()));
  if (!number || *number == 0 || *number > UINT32_MAX) return std::nullopt;
  return MissionOrder{MissionOrder::Kind::skip, static_cast<std::uint32_t>(*number - 1)};
}

}  // namespace tocsin
