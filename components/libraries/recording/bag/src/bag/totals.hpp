// SPDX-License-Identifier: Apache-2.0
// What files say of their messages, for all of a bag.
#pragma once

#include <cstdint>
#include <string>

#include "bag/metadata.hpp"
#include "mcap/format.hpp"

namespace tocsin::bag {

/// [ns] A time of a file, which may hold any number, as one that can be computed with.
[[nodiscard]] std::int64_t time_of(std::uint64_t ns);

[[nodiscard]] Metadata::File described(const std::string& path, const mcap::Statistics& statistics);

/// Sets the times and the number of messages of the whole bag by those of its files.
void set_totals(Metadata& metadata);

}  // namespace tocsin::bag
