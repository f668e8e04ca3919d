// SPDX-License-Identifier: Apache-2.0
#include "bag/topic.hpp"

#include "foundation/ros_names.hpp"
#include "idl_support/type_definition.hpp"

namespace tocsin::bag {

Topic make_topic(const std::string& wire_topic, const std::string& wire_type) {
  Topic topic;
  topic.name = ros_topic(wire_topic).value_or(wire_topic);
  topic.type = ros_type(wire_type);
  if (auto definition = ros2msg_definition(wire_type)) {
    topic.definition_encoding = "ros2msg";
    topic.definition = std::move(*definition);
  }
  return topic;
}

}  // namespace tocsin::bag
