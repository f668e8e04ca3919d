// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tocsin::bag {

/// In the metadata of a channel that is one writer's: its number. As in the segments of sample_log.
inline constexpr const char* writer_key = "writer";

}  // namespace tocsin::bag
