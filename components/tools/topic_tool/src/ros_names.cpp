// SPDX-License-Identifier: Apache-2.0
#include "ros_names.hpp"

#include <regex>

#include "foundation/error.hpp"

namespace tocsin::topic_tool {
namespace {

const std::string topic_prefix = "rt/";

}  // namespace

std::optional<std::string> ros_topic(const std::string& on_wire) {
  if (on_wire.compare(0, topic_prefix.size(), topic_prefix) != 0) return std::nullopt;
  return on_wire.substr(topic_prefix.size() - 1);
}

std::string wire_topic(const std::string& ros_name) {
  const bool absolute = !ros_name.empty() && ros_name.front() == '/';
  return topic_prefix + ros_name.substr(absolute ? 1 : 0);
}

std::string ros_type(const std::string& on_wire) {
  static const std::regex pattern("(\\w+)::(\\w+)::dds_::(\\w+)_");
  std::smatch parts;
  if (!std::regex_match(on_wire, parts, pattern)) return on_wire;
  return parts.str(1) + "/" + parts.str(2) + "/" + parts.str(3);
}

std::string wire_type(const std::string& ros_name) {
  static const std::regex pattern("(\\w+)/(?:(\\w+)/)?(\\w+)");
  std::smatch parts;
  if (!std::regex_match(ros_name, parts, pattern)) {
    throw ConfigError("'" + ros_name + "' is no message type; write std_msgs/msg/String");
  }
  const std::string kind = parts[2].matched ? parts.str(2) : "msg";
  return parts.str(1) + "::" + kind + "::dds_::" + parts.str(3) + "_";
}

}  // namespace tocsin::topic_tool
