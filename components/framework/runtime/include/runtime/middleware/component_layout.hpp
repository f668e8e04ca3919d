// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "runtime/port.hpp"

namespace tocsin {

/// Differs when a library and the runtime were compiled with different headers: the sizes of what
/// they share, and a number in front that is raised by hand when only a virtual function changes.
constexpr std::uint64_t component_layout() {
  std::uint64_t layout = 2;
  for (const std::size_t size :
       {sizeof(Component), sizeof(InputPort), sizeof(Schedule), sizeof(Context), sizeof(Sample),
        sizeof(TypeInfo), sizeof(SampleQueue), sizeof(PortHealth), sizeof(EndpointHealth)}) {
    layout = layout * 1000003U + size;
  }
  return layout;
}

}  // namespace tocsin
