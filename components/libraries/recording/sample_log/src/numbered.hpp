// SPDX-License-Identifier: Apache-2.0
// Names of files that follow each other: `segment.00000001.mcap`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace tocsin::sample_log {

/// Sorted by name they are sorted by number, below 10^8.
[[nodiscard]] std::string numbered(const std::string& name, std::uint64_t number,
                                   const std::string& extension);
/// Empty when the file has another name.
[[nodiscard]] std::optional<std::uint64_t> number_in(const std::string& file,
                                                     const std::string& name,
                                                     const std::string& extension);

}  // namespace tocsin::sample_log
