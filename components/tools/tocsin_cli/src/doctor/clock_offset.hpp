// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "advice.hpp"

namespace tocsin::doctor {

/// The bytes of an ICMP message.
using IcmpTimestamp = std::array<std::uint8_t, 20>;

/// A timestamp request (RFC 792, type 13) sent at `sent_ms` since midnight UTC.
[[nodiscard]] IcmpTimestamp timestamp_request(std::uint16_t id, std::uint32_t sent_ms);

/// How far the peer's clock is ahead of ours [ms], from its reply, received at `received_ms`: half
/// the difference of the two ways. Empty when it is no such reply. Right to about 1 ms on a link
/// whose two ways take equally long.
[[nodiscard]] std::optional<double> clock_ahead_ms(const std::uint8_t* icmp, std::size_t size,
                                                   std::uint16_t id, std::uint32_t received_ms);

/// What a difference means: ages and latencies of samples are computed from both clocks.
[[nodiscard]] Advice judge_clock(const std::string& peer, double ahead_ms);

/// Asks the kernel of `peer` (IPv4) for its time, waits at most 1 s. Needs CAP_NET_RAW.
[[nodiscard]] Advice compare_clock(const std::string& peer);

}  // namespace tocsin::doctor
