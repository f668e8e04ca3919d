// SPDX-License-Identifier: Apache-2.0
#include "foundation/ros_names.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <tuple>
#include <vector>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

// No std::string: objects of other sources that are made before main ask for names, too.
constexpr std::string_view topic_prefix = "rt/";

std::vector<std::string> parts_of(const std::string& text, const std::string& between) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(between, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string::npos) return parts;
    begin = end + between.size();
  }
}

bool is_identifier(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_';
  });
}

/// What stands between the two; empty when the text does not begin and end so.
std::optional<std::string> between(const std::string& text, const std::string& start,
                                   const std::string& end) {
  const std::size_t around = start.size() + end.size();
  if (text.size() <= around || text.compare(0, start.size(), start) != 0 ||
      text.compare(text.size() - end.size(), end.size(), end) != 0) {
    return std::nullopt;
  }
  return text.substr(start.size(), text.size() - around);
}

}  // namespace

std::optional<std::string> ros_topic(const std::string& on_wire) {
  if (on_wire.compare(0, topic_prefix.size(), topic_prefix) != 0) return std::nullopt;
  return on_wire.substr(topic_prefix.size() - 1);
}

std::string wire_topic(const std::string& ros_name) {
  const bool absolute = !ros_name.empty() && ros_name.front() == '/';
  return std::string(topic_prefix) + ros_name.substr(absolute ? 1 : 0);
}

std::string ros_type(const std::string& on_wire) {
  const auto parts = parts_of(on_wire, "::");
  if (parts.size() != 4 || parts[2] != "dds_" || parts[3].size() < 2 || parts[3].back() != '_') {
    return on_wire;
  }
  return parts[0] + "/" + parts[1] + "/" + parts[3].substr(0, parts[3].size() - 1);
}

std::string wire_type(const std::string& ros_name) {
  auto parts = parts_of(ros_name, "/");
  if (parts.size() == 2) parts.insert(parts.begin() + 1, "msg");
  if (parts.size() != 3 || !std::all_of(parts.begin(), parts.end(), is_identifier)) {
    throw ConfigError("'" + ros_name + "' is no message type; write std_msgs/msg/String");
  }
  return parts[0] + "::" + parts[1] + "::dds_::" + parts[2] + "_";
}

std::string absolute(const std::string& ros_name) {
  return !ros_name.empty() && ros_name.front() == '/' ? ros_name : "/" + ros_name;
}

std::optional<RosService> ros_service(const std::string& on_wire) {
  for (const auto& [start, end, half] :
       {std::tuple{"rq/", "Request", ServiceHalf::request}, {"rr/", "Reply", ServiceHalf::reply}}) {
    const auto name = between(on_wire, start, end);
    if (name) return RosService{"/" + *name, half};
  }
  return std::nullopt;
}

std::string ros_service_type(const std::string& on_wire) {
  const std::string type = ros_type(on_wire);
  for (const char* const end : {"_Request", "_Response"}) {
    if (const auto name = between(type, "", end)) return *name;
  }
  return type;
}

}  // namespace tocsin
