// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "foundation/link_path.hpp"
#include "foundation/parameters.hpp"
#include "foundation/traffic_class.hpp"

namespace tocsin {

/// The file's map `paths`.
struct PathsEntry {
  PathUse critical = policy_of(TrafficClass::critical).paths;
  PathUse high = policy_of(TrafficClass::high).paths;
  PathUse normal = policy_of(TrafficClass::normal).paths;
  PathUse low = policy_of(TrafficClass::low).paths;
  template <class Visitor>
  void visit(Visitor& v) {
    const Choices words{"best", "repair", "both"};
    visit_enum(v, "critical", critical, words, "paths of class critical, where there are two");
    visit_enum(v, "high", high, words, "paths of class high");
    visit_enum(v, "normal", normal, words, "paths of class normal");
    visit_enum(v, "low", low, words, "paths of class low");
  }
};

[[nodiscard]] inline std::array<PathUse, traffic_classes.size()> to_paths(const PathsEntry& entry) {
  return {entry.critical, entry.high, entry.normal, entry.low};
}

}  // namespace tocsin
