// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace tocsin {

/// Options of the encapsulation header (RTPS 2.2, section 10.2; unused in XCDR1) by which we mark
/// bytes that are the key fields of a message and nothing else. TypeInfo::deserialize reads them,
/// too. Never on the wire.
inline constexpr std::uint8_t key_only_options[2] = {0x4b, 0xc5};

[[nodiscard]] inline bool is_key_only(const std::uint8_t* encoded, std::size_t size) {
  return size >= 4 && encoded[2] == key_only_options[0] && encoded[3] == key_only_options[1];
}

}  // namespace tocsin
