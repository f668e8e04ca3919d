// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tocsin::archive {

/// A closed MCAP file of a bag, and whose it is.
struct Recording {
  std::filesystem::path path;
  std::string id;  ///< of its content: 16 digits of SHA-256 over its size and its last 64 KiB
  std::uint64_t bytes = 0;
  std::string vehicle;  ///< by the run's deployment.yaml; "unknown" of a bag of no run
  std::string host;     ///< that recorded it; empty of a bag of no run
  std::string run;      ///< name of the run's folder, or of the bag's
};

/// All closed MCAP files below the folders, by path. One that is still written, or was cut, has no
/// end and is left out. Throws ConfigError for a folder that is none.
[[nodiscard]] std::vector<Recording> closed_recordings(const std::vector<std::string>& folders);

/// Its name in the archive: VEHICLE/RUN/HOST_FILE-ID.mcap.
[[nodiscard]] std::string object_of(const Recording& recording);

}  // namespace tocsin::archive
