// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "bag/bag_reader.hpp"

namespace tocsin::bag_tool {

/// What `ros2 bag info` prints of a bag, and behind it a line for each file that lacks something.
[[nodiscard]] std::string info_text(const bag::BagReader& reader);

/// `1.2 MiB`, as `ros2 bag` rounds it.
[[nodiscard]] std::string size_text(std::uint64_t bytes);

/// What a file lacks, in words; empty: nothing.
[[nodiscard]] std::string damage_text(const mcap::Damage& damage);

}  // namespace tocsin::bag_tool
