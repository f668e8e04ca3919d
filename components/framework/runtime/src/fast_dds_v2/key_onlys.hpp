// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace tocsin {

/// Lets Fast DDS 2.9.1 hear that a participant, an end or an instance of another vendor has ended.
///
/// Who ends one says so by DATA with a key and no data (RTPS 2.2 sections 8.3.7.2, 8.5.3.3). Fast
/// DDS takes the hash of the key from the inline QoS (PID_KEY_HASH), ignores keys of more than 16
/// bytes, and takes shorter ones for the hash; Cyclone DDS sends nothing but the key, so that a
/// participant would be missed until its lease ends, 10 s later, and an instance for ever. Here
/// - discovery gets the hash, which is the GUID itself;
/// - the key of a topic becomes data, marked as a key-only DATA (idl_support/key_only.hpp), from
/// which
///   Fast DDS has its type compute the hash.
///
/// Returns the message to hand on: `message` itself, or `changed`, which is overwritten. Pure.
[[nodiscard]] std::pair<const std::uint8_t*, std::size_t> with_key_onlys(
    const std::uint8_t* message, std::size_t size, std::vector<std::uint8_t>& changed);

}  // namespace tocsin
