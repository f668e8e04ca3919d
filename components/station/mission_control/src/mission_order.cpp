// SPDX-License-Identifier: Apache-2.0
#include "mission_control/mission_order.hpp"

#include <charconv>

namespace tocsin {
namespace {

constexpr const char* skip = "skip ";

/// The number that all of `text` is; nothing for another text.
std::optional<std::uint32_t> whole_number(const std::string& text) {
  std::uint32_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [behind, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || behind != end) return std::nullopt;
  return number;
}

}  // namespace

std::optional<MissionOrder> mission_order_of(const std::string& words) {
  if (words == "pause") return MissionOrder{MissionOrder::Kind::pause};
  if (words == "resume") return MissionOrder{MissionOrder::Kind::resume};
  if (words.rfind(skip, 0) != 0) return std::nullopt;
  const auto number = whole_number(words.substr(std::string(skip).size()));
  if (!number || *number == 0) return std::nullopt;
  return MissionOrder{MissionOrder::Kind::skip, *number - 1};
}

}  // namespace tocsin
