// SPDX-License-Identifier: Apache-2.0
#include "totals.hpp"

#include <algorithm>

namespace tocsin::bag {

std::int64_t time_of(std::uint64_t ns) {
  constexpr std::uint64_t latest = 9'000'000'000'000'000'000U;  // the year 2255
  return static_cast<std::int64_t>(std::min(ns, latest));
}

Metadata::File described(const std::string& path, const mcap::Statistics& statistics) {
  const std::int64_t start_ns = time_of(statistics.start_ns);
  return {path, start_ns, time_of(statistics.end_ns) - start_ns, statistics.message_count};
}

void set_totals(Metadata& metadata) {
  metadata.start_ns = metadata.duration_ns = 0;
  metadata.count = 0;
  std::int64_t end_ns = 0;
  for (const Metadata::File& file : metadata.files) {
    if (file.count == 0) continue;
    const bool first = metadata.count == 0;
    metadata.start_ns = first ? file.start_ns : std::min(metadata.start_ns, file.start_ns);
    end_ns = std::max(end_ns, file.start_ns + file.duration_ns);
    metadata.duration_ns = end_ns - metadata.start_ns;
    metadata.count += file.count;
  }
}

}  // namespace tocsin::bag
