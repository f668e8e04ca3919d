// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "idl_support/type_info.hpp"

namespace tocsin {

/// The message of that type that `encode` made these bytes of; null when they are no such message.
[[nodiscard]] inline std::shared_ptr<void> decode(const TypeInfo& type,
                                                  const std::vector<std::uint8_t>& bytes) {
  auto message = type.create();
  return type.deserialize(bytes.data(), bytes.size(), message.get()) ? message : nullptr;
}

}  // namespace tocsin
