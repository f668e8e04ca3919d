// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace tocsin::bench {

/// [ms] of many runs; each is the least of five, so that other processes do not count.
struct Timing {
  double mean_ms = 0;
  double p99_ms = 0;
};

/// A scan of 360 beams in a submap of a drawn building, window 0.3 m and 15 degrees on both sides.
[[nodiscard]] Timing time_matches();
/// Readings of eight scans in another submap of it, window 4 m and 45 degrees on both sides, with
/// the look for a second place that is as good.
[[nodiscard]] Timing time_loop_searches();
/// A graph of that many nodes with a loop for each third, after a new loop.
[[nodiscard]] Timing time_solve(std::size_t nodes);

}  // namespace tocsin::bench
