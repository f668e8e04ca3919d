// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "foundation/stop_value.hpp"

namespace tocsin {

/// As a submessage's content, little endian; lists and names are cut to their bounds.
[[nodiscard]] std::vector<std::uint8_t> to_bytes(const StopValue& value);
/// The value and how many bytes it took; nothing for bytes that are none. What follows is not read.
[[nodiscard]] std::optional<std::pair<StopValue, std::size_t>> stop_value_in(
    const std::uint8_t* bytes, std::size_t size);

}  // namespace tocsin
