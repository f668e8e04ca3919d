// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "foundation/traffic_class.hpp"

namespace tocsin {

/// The file's map `dscp`.
struct DscpEntry {
  int critical = tocsin::dscp(TrafficClass::critical);
  int high = tocsin::dscp(TrafficClass::high);
  int normal = tocsin::dscp(TrafficClass::normal);
  int low = tocsin::dscp(TrafficClass::low);
  template <class Visitor>
  void visit(Visitor& v) {
    v("critical", critical, {0, 63}, "[1] DSCP of the packets of class critical");
    v("high", high, {0, 63}, "[1] DSCP of the packets of class high");
    v("normal", normal, {0, 63}, "[1] DSCP of the packets of class normal");
    v("low", low, {0, 63}, "[1] DSCP of the packets of class low");
  }
};

[[nodiscard]] inline DscpOfClass to_dscp(const DscpEntry& entry) {
  DscpOfClass dscp;
  dscp.set(TrafficClass::critical, static_cast<std::uint8_t>(entry.critical));
  dscp.set(TrafficClass::high, static_cast<std::uint8_t>(entry.high));
  dscp.set(TrafficClass::normal, static_cast<std::uint8_t>(entry.normal));
  dscp.set(TrafficClass::low, static_cast<std::uint8_t>(entry.low));
  return dscp;
}

}  // namespace tocsin
