// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "ros_idl/builtin_interfaces.hpp"

namespace tocsin {

/// The stamp of a message: `wall_ns` [ns] since the Unix epoch, not negative.
[[nodiscard]] inline builtin_interfaces::msg::Time ros_stamp(std::int64_t wall_ns) {
  constexpr std::int64_t second = 1'000'000'000;
  builtin_interfaces::msg::Time stamp;
  stamp.sec(static_cast<std::int32_t>(wall_ns / second));
  stamp.nanosec(static_cast<std::uint32_t>(wall_ns % second));
  return stamp;
}

}  // namespace tocsin
