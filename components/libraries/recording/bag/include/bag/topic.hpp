// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bag/offered_qos.hpp"

namespace tocsin::bag {

/// A topic of a bag, with the names that it has in ROS.
struct Topic {
  std::string name;  ///< `/odom`
  std::string type;  ///< `nav_msgs/msg/Odometry`
  std::string serialization_format = "cdr";
  std::string definition_encoding;  ///< `ros2msg`, `ros2idl`, ...; empty: there is no definition
  std::string definition;
  std::vector<OfferedQos> offered_qos;
};

/// A topic by its names on the wire, `rt/odom` and `nav_msgs::msg::dds_::Odometry_`, with the
/// definition of its type when a loaded library knows it.
[[nodiscard]] Topic make_topic(const std::string& wire_topic, const std::string& wire_type);

/// A message; its bytes, with their encapsulation header, belong to somebody else.
struct Message {
  std::uint32_t sequence = 0;
  std::int64_t log_time_ns = 0;      ///< when it was received, since the Unix epoch
  std::int64_t publish_time_ns = 0;  ///< when it was sent
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;
  std::uint64_t writer = 0;  ///< who wrote it, a number of the recorder's; 0: not told
};

}  // namespace tocsin::bag
