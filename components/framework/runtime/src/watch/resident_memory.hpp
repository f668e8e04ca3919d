// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tocsin {

/// Bytes of a mebibyte.
inline constexpr double mib = 1024.0 * 1024.0;

/// Resident memory of this process [byte]; 0 when /proc does not tell.
[[nodiscard]] std::uint64_t resident_bytes();

}  // namespace tocsin
