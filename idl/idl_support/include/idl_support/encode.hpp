// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "idl_support/type_info.hpp"

namespace tocsin {

/// A message of that type as it stands on the wire, encapsulation header included.
[[nodiscard]] inline std::vector<std::uint8_t> encode(const TypeInfo& type, const void* message) {
  std::vector<std::uint8_t> bytes(type.serialized_size(message));
  bytes.resize(type.serialize(message, bytes.data(), bytes.size()));
  return bytes;
}

}  // namespace tocsin
