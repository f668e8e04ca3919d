// SPDX-License-Identifier: Apache-2.0
// Short random runs of two routers' decisions under faults: link_router_faults FIRST COUNT. Prints
// each seed that breaks an invariant.
#include <cstdio>
#include <cstdlib>

#include "faulty_link.hpp"

int main(int argc, char** argv) {
  const auto first = static_cast<unsigned>(argc > 1 ? std::atoi(argv[1]) : 1);
  const auto count = static_cast<unsigned>(argc > 2 ? std::atoi(argv[2]) : 100'000);
  unsigned broken = 0;
  std::size_t deliveries = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    tocsin::router::FaultyLink link(seed);
    const std::string what = link.run();
    deliveries += link.deliveries();
    if (what.empty()) continue;
    ++broken;
    std::printf("seed %u: %s\n", seed, what.c_str());
  }
  std::printf("%u runs, %zu deliveries, %u broken\n", count, deliveries, broken);
  return broken == 0 ? 0 : 1;
}
