// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace tocsin {

/// Room that is left for this user on the disk of a folder [byte]; 0 also when no further file can
/// be made. Empty when the folder is not there, or its file system does not tell.
[[nodiscard]] std::optional<std::uint64_t> free_bytes(const std::string& folder);

/// The same as a share of the whole disk [1].
[[nodiscard]] std::optional<double> free_share(const std::string& folder);

/// With less than this a disk counts as full [byte]: the next file may not fit any more.
inline constexpr std::uint64_t full_below_bytes = 1U << 20U;

}  // namespace tocsin
