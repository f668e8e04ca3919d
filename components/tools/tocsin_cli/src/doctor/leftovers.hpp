// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tocsin::doctor {

/// Shared memory of Fast DDS that no process uses any more.
struct Leftovers {
  std::vector<std::filesystem::path> files;
  std::uintmax_t bytes = 0;
};

/// Files of Fast DDS in `folder` (normally /dev/shm) that no process has mapped or open: segments
/// and ports of the transport (`fastrtps_*`, `sem.fastrtps_*`) and data-sharing histories
/// (`fast_datasharing_*`, which `fastdds shm clean` leaves behind). Files of other users count only
/// for root, who can see whether they are in use.
[[nodiscard]] Leftovers find_leftovers(const std::filesystem::path& folder);

/// Removes the files and returns how many went.
std::size_t remove(const Leftovers& leftovers);

}  // namespace tocsin::doctor
