// SPDX-License-Identifier: Apache-2.0
#include "foundation/traffic_class.hpp"

namespace tocsin {

const char* to_string(TrafficClass traffic_class) {
  switch (traffic_class) {
    case TrafficClass::critical:
      return "critical";
    case TrafficClass::high:
      return "high";
    case TrafficClass::normal:
      return "normal";
    case TrafficClass::low:
      return "low";
  }
  return "unknown";
}

std::optional<TrafficClass> traffic_class_of(std::string_view word) {
  for (const TrafficClass one : traffic_classes) {
    if (word == to_string(one)) return one;
  }
  return std::nullopt;
}

}  // namespace tocsin
