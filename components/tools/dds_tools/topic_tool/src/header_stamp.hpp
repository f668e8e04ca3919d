// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "idl_support/type_info.hpp"

namespace tocsin::topic_tool {

/// `header.stamp` of a message [ns] since the Unix epoch; empty when its type has none.
[[nodiscard]] std::optional<std::int64_t> header_stamp_ns(const TypeInfo& type,
                                                          const void* message);

}  // namespace tocsin::topic_tool
