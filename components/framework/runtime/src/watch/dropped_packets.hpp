// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "rtps_filter/drop_account.hpp"

namespace tocsin {

/// Counts a packet that a participant of this process was not shown. Any thread.
void count_dropped_packet(rtps_filter::DropReason reason, std::uint32_t address);
/// All of them since the process began. Any thread.
[[nodiscard]] rtps_filter::DropAccount dropped_packets();

}  // namespace tocsin
