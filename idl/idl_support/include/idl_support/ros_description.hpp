// SPDX-License-Identifier: Apache-2.0
// Message types in the words of ROS 2's package type_description_interfaces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tocsin {

/// One field, as type_description_interfaces/msg/FieldType has it. All texts are literals.
struct RosField {
  const char* name;
  std::uint8_t type_id;
  std::uint32_t capacity;         ///< of an array or a bounded sequence; 0: not one
  std::uint32_t string_capacity;  ///< of a bounded string; 0: not one
  const char* nested_type_name;   ///< as `geometry_msgs/msg/Vector3`; empty: a type of its own
};

/// One type, and what its hash is made of.
struct RosDescription {
  const char* name;  ///< as `geometry_msgs/msg/Twist`; a literal
  const char* hash;  ///< TypeInfo::ros_hash; a literal
  const RosField* fields;
  std::size_t size;  ///< of `fields`
};

/// Makes a description known. Called by generated code before main.
void register_ros_description(const RosDescription& description);

/// A type and, sorted by name behind it, all types that it is made of, at any depth.
/// Empty when no loaded library has a type of this hash. Any thread.
[[nodiscard]] std::vector<RosDescription> describe_ros_hash(const std::string& hash);

}  // namespace tocsin
