// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mcap/recovery.hpp"

namespace tocsin::bag {

/// What became of one file of a bag.
struct RecoveredFile {
  std::string name;
  mcap::Recovered recovered;
};

/// Copies all that can be read of a bag, or of one MCAP file, into a new bag, file by file, with
/// the memory of one chunk. All MCAP files of a folder are taken, whatever its metadata.yaml says.
/// Throws ConfigError when `from` has no MCAP file, or `folder` is there already.
[[nodiscard]] std::vector<RecoveredFile> recover_bag(const std::string& from,
                                                     const std::string& folder);

}  // namespace tocsin::bag
