// SPDX-License-Identifier: Apache-2.0
#include "foundation/traffic_class.hpp"

#include <cassert>

namespace tocsin {
namespace {

constexpr std::array<ClassPolicy, traffic_classes.size()> policies{{
    {"critical", 48, true, true, PathUse::repair},  // CS6
    {"high", 32, true, true, PathUse::repair},      // CS4
    {"normal", 0, false, false, PathUse::best},
    {"low", 8, false, false, PathUse::best},  // CS1
}};

}  // namespace

const ClassPolicy& policy_of(TrafficClass traffic_class) {
  const auto row = static_cast<std::size_t>(traffic_class);
  assert(row < policies.size());
  return policies[row];
}

std::optional<TrafficClass> traffic_class_of(std::string_view word) {
  for (const TrafficClass one : traffic_classes) {
    if (word == to_string(one)) return one;
  }
  return std::nullopt;
}

}  // namespace tocsin
