// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "bag/bag_reader.hpp"

namespace tocsin::bag {

/// [ns] A time of a file, which may hold any number, as one that can be computed with.
[[nodiscard]] std::int64_t time_of(std::uint64_t ns);

/// All files as one, by log time. `files` and `topics` must outlive it.
[[nodiscard]] std::unique_ptr<BagStream> merged(std::vector<BagReader::File>& files,
                                                const std::vector<Metadata::TopicCount>& topics,
                                                const Selection& selection);

}  // namespace tocsin::bag
