// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "bag/bag_reader.hpp"

namespace tocsin::bag {

/// All files as one, by log time. `files` and `topics` must outlive it.
[[nodiscard]] std::unique_ptr<BagStream> merged(std::vector<BagReader::File>& files,
                                                const std::vector<Metadata::TopicCount>& topics,
                                                const Selection& selection);

}  // namespace tocsin::bag
