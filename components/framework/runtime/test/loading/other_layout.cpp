// SPDX-License-Identifier: Apache-2.0
// A component's library as other headers of the runtime would have made it: with another layout,
// and nothing behind it that the runtime could call.
#include <cstdint>

namespace tocsin {
struct ComponentEntry;
}

extern "C" const tocsin::ComponentEntry* tocsin_component() {
  static constexpr std::uint64_t layout = 0x2a;
  return reinterpret_cast<const tocsin::ComponentEntry*>(&layout);
}
