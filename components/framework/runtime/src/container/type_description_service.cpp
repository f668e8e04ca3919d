// SPDX-License-Identifier: Apache-2.0
#include "container/type_description_service.hpp"

#include <utility>
#include <vector>

#include "foundation/printable.hpp"
#include "graph/type_hash.hpp"
#include "idl_support/ros_description.hpp"
#include "idl_support/type_definition.hpp"

namespace tocsin {
namespace {

using type_description_interfaces::msg::Field;
using type_description_interfaces::msg::IndividualTypeDescription;
using type_description_interfaces::msg::TypeSource;

Field field_of(const RosField& from) {
  Field field;
  field.name(from.name);
  field.type().type_id(from.type_id);
  field.type().capacity(from.capacity);
  field.type().string_capacity(from.string_capacity);
  field.type().nested_type_name(from.nested_type_name);
  return field;
}

IndividualTypeDescription individual(const RosDescription& from) {
  IndividualTypeDescription description;
  description.type_name(from.name);
  for (std::size_t i = 0; i < from.size; ++i) {
    description.fields().push_back(field_of(from.fields[i]));
  }
  return description;
}

/// `geometry_msgs::msg::dds_::Twist_` of `geometry_msgs/msg/Twist`.
std::string wire_name(const std::string& ros_name) {
  const std::size_t first = ros_name.find('/');
  const std::size_t last = ros_name.rfind('/');
  return ros_name.substr(0, first) + "::" + ros_name.substr(first + 1, last - first - 1) +
         "::dds_::" + ros_name.substr(last + 1) + "_";
}

/// A part of a service or an action has no file of its own.
TypeSource ros_source_of(const RosDescription& type) {
  TypeSource source;
  source.type_name(type.name);
  const bool is_message = source.type_name().find("/msg/") != std::string::npos;
  const auto definition = find_definition(wire_name(type.name));
  source.encoding(is_message && definition ? "msg" : "implicit");
  if (is_message && definition) source.raw_file_contents(definition->text);
  return source;
}

GetTypeDescription::Response no_description(std::string reason) {
  GetTypeDescription::Response response;
  response.failure_reason(std::move(reason));
  return response;
}

}  // namespace

GetTypeDescription::Response describe_type(const GetTypeDescription::Request& request) {
  const std::string& hash = request.type_hash();
  if (!is_type_hash(hash)) {
    return no_description("'" + printable(hash, 80) +
                          "' is no type hash: RIHS01_ and 64 of 0 to 9, a to f");
  }
  const std::vector<RosDescription> types = describe_ros_hash(hash);
  if (types.empty()) return no_description("no type of this node has the hash " + hash);
  GetTypeDescription::Response response;
  response.successful(true);
  response.type_description().type_description(individual(types[0]));
  for (std::size_t i = 1; i < types.size(); ++i) {
    response.type_description().referenced_type_descriptions().push_back(individual(types[i]));
  }
  if (!request.include_type_sources()) return response;
  for (const RosDescription& type : types) response.type_sources().push_back(ros_source_of(type));
  return response;
}

TypeDescriptionService::TypeDescriptionService(Component& owner, const std::string& node)
    : get_(owner, GetTypeDescription::name, node) {}

void TypeDescriptionService::answer() {
  while (const auto call = get_.take()) get_.reply(call->id, describe_type(*call->request));
}

}  // namespace tocsin
