// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "foundation/link_path.hpp"

namespace tocsin {

/// How urgent a link topic is, the most urgent first.
enum class TrafficClass : std::uint8_t { critical, high, normal, low };

inline constexpr std::array<TrafficClass, 4> traffic_classes{
    TrafficClass::critical, TrafficClass::high, TrafficClass::normal, TrafficClass::low};

/// How the link treats a class. A new class is a row of the table of traffic_class.cpp.
struct ClassPolicy {
  const char* name;     ///< the word of a traffic file
  std::uint8_t dscp;    ///< default code point, see DscpOfClass
  bool repaired;        ///< what is not acknowledged is sent again
  bool passes_backlog;  ///< small samples go although the radio's queue is long or no peer answers
  PathUse paths;        ///< where there are two, unless the traffic file says otherwise
};
[[nodiscard]] const ClassPolicy& policy_of(TrafficClass traffic_class);

/// The word of a traffic file: "critical" and so on.
[[nodiscard]] inline const char* to_string(TrafficClass traffic_class) {
  return policy_of(traffic_class).name;
}
/// The class of a word; empty when it is none.
[[nodiscard]] std::optional<TrafficClass> traffic_class_of(std::string_view word);

/// The differentiated services code point (RFC 2474, 0 to 63) that the packets of each class carry.
/// It stands in the upper six bits of the IP header's TOS byte. The defaults come out in the four
/// Wi-Fi categories voice, video, best effort and background, by the upper three bits, as
/// older Linux kernels map them, and by RFC 8325, as newer ones do.
class DscpOfClass {
 public:
  DscpOfClass() {
    for (const TrafficClass one : traffic_classes) set(one, policy_of(one).dscp);
  }
  [[nodiscard]] std::uint8_t of(TrafficClass traffic_class) const {
    return of_[static_cast<std::size_t>(traffic_class)];
  }
  /// `dscp` at most 63.
  void set(TrafficClass traffic_class, std::uint8_t dscp) {
    of_[static_cast<std::size_t>(traffic_class)] = dscp;
  }

 private:
  std::array<std::uint8_t, traffic_classes.size()> of_{};
};

/// The default DSCP of a class.
[[nodiscard]] inline std::uint8_t dscp(TrafficClass traffic_class) {
  return policy_of(traffic_class).dscp;
}

}  // namespace tocsin
