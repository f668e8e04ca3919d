// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "object_store.hpp"
#include "recording_index.hpp"

namespace tocsin::archive {

/// Where an archive is.
struct Places {
  std::string store = "archive";  ///< folder, or s3://BUCKET/PREFIX
  std::string index;              ///< postgresql://..., or a file of SQLite; empty: in the folder
};
/// Throws ConfigError when there is no place for the index.
[[nodiscard]] std::string index_of(const Places& places);

/// What came of one round.
struct Round {
  std::size_t added = 0;
  std::size_t known = 0;
  std::vector<std::string> problems;  ///< a line for each recording that is not in the archive
};

/// Puts all closed recordings below the folders that the index does not have into the store, and
/// then into the index: whoever finds one in the index finds it in the store. What was interrupted
/// anywhere is done again and is the same. Throws ConfigError for a folder that is none, and
/// EnvironmentError when the index cannot be reached.
[[nodiscard]] Round archive(const std::vector<std::string>& folders, ObjectStore& store,
                            RecordingIndex& index);

}  // namespace tocsin::archive
