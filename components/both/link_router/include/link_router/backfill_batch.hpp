// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sample_log/sample_log.hpp"

namespace tocsin::router {

/// Stored samples of one stream, in the order of their writers, on their way to a peer.
struct BackfillBatch {
  std::uint32_t session = 0;
  std::uint32_t number = 0;  ///< 1, 2, 3, ... in a session
  std::uint64_t stream = 0;  ///< stream_key of its name
  std::vector<sample_log::LogEntry> samples;
};

/// Up to where a peer has delivered what it was sent.
struct BackfillProgress {
  std::uint32_t session = 0;
  std::uint32_t number = 0;  ///< all up to this one
};

/// Of one stored stream, counted since the start of the router.
struct StoredCounts {
  std::uint64_t stored = 0;      ///< written to the log
  std::uint64_t backfilled = 0;  ///< that did not cross live and were delivered later
  std::uint64_t expired = 0;     ///< that the log's bounds took before they were delivered
  std::uint64_t refused = 0;  ///< that the log could not take, or not read, and that did not cross
  std::size_t waiting = 0;    ///< now: in the log, and still to cross
};

}  // namespace tocsin::router
