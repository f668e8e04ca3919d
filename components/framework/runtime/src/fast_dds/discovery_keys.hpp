// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace tocsin {

/// Lets Fast DDS 2.9.1 hear that a participant of Cyclone DDS, or an end of it, has left.
///
/// Who leaves says so by DATA without data in discovery, with the GUID as its key (RTPS 2.2
/// section 8.5.3.3). Fast DDS takes it from the inline QoS (PID_KEY_HASH) and ignores keys of more
/// than 16 bytes; Cyclone DDS sends nothing but such a key, so that it would be missed until its
/// lease ends, 10 s later. Here the hash, which is the GUID itself, is added.
///
/// Returns the message to hand on: `message` itself, or `changed`, which is overwritten. Pure.
[[nodiscard]] std::pair<const std::uint8_t*, std::size_t> with_discovery_keys(
    const std::uint8_t* message, std::size_t size, std::vector<std::uint8_t>& changed);

}  // namespace tocsin
