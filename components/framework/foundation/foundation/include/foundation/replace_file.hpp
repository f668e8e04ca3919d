// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <system_error>

namespace tocsin {

/// Whether a replaced file must survive that the computer loses its power.
enum class Sync {
  yes,  ///< fsync(2) before the rename; may take as long as the disk takes
  no,   ///< safe against full disks and killed processes only
};

/// Replaces a file in one step: readers see the old text or the new one, whole. The new text is
/// written beside it, as `path` + ".new", and takes its place only when all of it was written.
///
/// What is no file, such as /dev/stdout, is written to and stays what it is.
///
/// Returns why that failed (no_space_on_device, ...); the old file stays as it is then, and the new
/// one is removed. Only one thread or process may replace a file at a time.
[[nodiscard]] std::error_code replace_file(const std::string& path, const std::string& text,
                                           Sync sync = Sync::yes);

/// Whether there was no room: a full disk or a spent quota.
[[nodiscard]] bool is_disk_full(const std::error_code& error);

}  // namespace tocsin
