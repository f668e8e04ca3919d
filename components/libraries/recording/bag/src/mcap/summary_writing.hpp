// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "mcap/format.hpp"

namespace tocsin::mcap {

struct SummaryParts {
  const std::map<std::uint16_t, Schema>& schemas;
  std::vector<const Channel*> channels;
  const Statistics& statistics;
  const std::vector<ChunkIndex>& chunks;
  const std::vector<AttachmentIndex>& attachments;
  const std::vector<MetadataIndex>& metadata;
};

/// Everything from DataEnd to the last magic of a file whose DataEnd stands at `offset`.
[[nodiscard]] Bytes end_of_file(const SummaryParts& parts, std::uint64_t offset, bool crc);

}  // namespace tocsin::mcap
