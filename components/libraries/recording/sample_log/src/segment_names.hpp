// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tocsin::sample_log {

/// Of a log's segments, with a number between: `segment.00000001.mcap`.
inline constexpr const char* segment_name = "segment";
inline constexpr const char* segment_extension = ".mcap";

}  // namespace tocsin::sample_log
