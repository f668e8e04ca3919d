// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "ros_idl/sensor_msgs.hpp"

namespace tocsin::bench {

using HopMessage = sensor_msgs::msg::CompressedImage;

/// Tells who sends it, in three letters, and that it is written now.
inline HopMessage hop_message(std::size_t octets, const char* sender) {
  HopMessage message;
  message.data().resize(octets);
  message.header().frame_id(sender);
  const std::int64_t now = std::chrono::duration_cast<std::chrono::nanoseconds>(
                               std::chrono::system_clock::now().time_since_epoch())
                               .count();
  message.header().stamp().sec(static_cast<std::int32_t>(now / 1'000'000'000));
  message.header().stamp().nanosec(static_cast<std::uint32_t>(now % 1'000'000'000));
  return message;
}

}  // namespace tocsin::bench
