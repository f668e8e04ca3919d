// SPDX-License-Identifier: Apache-2.0
#include "operator_server/parameter_value.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "foundation/names.hpp"

namespace tocsin::foxglove {
namespace {

using nlohmann::json;
using RosValue = rcl_interfaces::msg::ParameterValue;
namespace ros = rcl_interfaces::msg::ParameterType_Constants;

template <class Test>
bool all_are(const json& list, Test test) {
  return std::all_of(list.begin(), list.end(), test);
}

bool is_whole(const json& value) {
  constexpr std::uint64_t most = 0x7fff'ffff'ffff'ffff;
  return value.is_number_integer() &&
         (!value.is_number_unsigned() || value.get<std::uint64_t>() <= most);
}

std::optional<RosValue> list_value(const Parameter& parameter, std::uint8_t known_type) {
  const json& list = parameter.value;
  RosValue made;
  const bool wants_doubles =
      parameter.type == "float64_array" || known_type == ros::PARAMETER_DOUBLE_ARRAY;
  const bool wants_texts = known_type == ros::PARAMETER_STRING_ARRAY;
  if (all_are(list, [](const json& one) { return one.is_string(); }) &&
      (!list.empty() || wants_texts)) {
    made.type(ros::PARAMETER_STRING_ARRAY);
    made.string_array_value(list.get<std::vector<std::string>>());
  } else if (all_are(list, is_whole) && !wants_doubles) {
    made.type(ros::PARAMETER_INTEGER_ARRAY);
    made.integer_array_value(list.get<std::vector<std::int64_t>>());
  } else if (all_are(list, [](const json& one) { return one.is_number(); })) {
    made.type(ros::PARAMETER_DOUBLE_ARRAY);
    made.double_array_value(list.get<std::vector<double>>());
  } else if (all_are(list, [](const json& one) { return one.is_boolean(); })) {
    made.type(ros::PARAMETER_BOOL_ARRAY);
    made.bool_array_value(list.get<std::vector<bool>>());
  } else {
    return std::nullopt;
  }
  return made;
}

std::optional<RosValue> number_value(const Parameter& parameter, std::uint8_t known_type) {
  RosValue made;
  const bool wants_double = parameter.type == "float64" || known_type == ros::PARAMETER_DOUBLE;
  if (is_whole(parameter.value) && !wants_double) {
    made.type(ros::PARAMETER_INTEGER);
    made.integer_value(parameter.value.get<std::int64_t>());
  } else {
    made.type(ros::PARAMETER_DOUBLE);
    made.double_value(parameter.value.get<double>());
  }
  return made;
}

/// JSON has no NaN and no infinity.
json number_or_null(double value) { return std::isfinite(value) ? json(value) : json(); }

json doubles(const std::vector<double>& values) {
  json list = json::array();
  for (const double value : values) list.push_back(number_or_null(value));
  return list;
}

}  // namespace

std::optional<ParameterName> split_parameter_name(const std::string& name) {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos || dot + 1 == name.size()) return std::nullopt;
  ParameterName split{without_slash(name.substr(0, dot)), name.substr(dot + 1)};
  return split.node.empty() ? std::nullopt : std::optional<ParameterName>(split);
}

std::string joined_parameter_name(const ParameterName& name) {
  return "/" + name.node + "." + name.parameter;
}

Parameter shown_parameter(const std::string& name, const RosValue& value) {
  switch (value.type()) {
    case ros::PARAMETER_BOOL:
      return {name, value.bool_value(), ""};
    case ros::PARAMETER_INTEGER:
      return {name, value.integer_value(), ""};
    case ros::PARAMETER_DOUBLE:
      return {name, number_or_null(value.double_value()), "float64"};
    case ros::PARAMETER_STRING:
      return {name, value.string_value(), ""};
    case ros::PARAMETER_BOOL_ARRAY:
      return {name, value.bool_array_value(), ""};
    case ros::PARAMETER_INTEGER_ARRAY:
      return {name, value.integer_array_value(), ""};
    case ros::PARAMETER_DOUBLE_ARRAY:
      return {name, doubles(value.double_array_value()), "float64_array"};
    case ros::PARAMETER_STRING_ARRAY:
      return {name, value.string_array_value(), ""};
    default:
      return {name, nullptr, ""};
  }
}

std::optional<RosValue> given_value(const Parameter& parameter, std::uint8_t known_type) {
  const json& value = parameter.value;
  RosValue made;
  if (value.is_array()) return list_value(parameter, known_type);
  if (value.is_number()) return number_value(parameter, known_type);
  if (value.is_boolean()) {
    made.type(ros::PARAMETER_BOOL);
    made.bool_value(value.get<bool>());
    return made;
  }
  if (!value.is_string()) return std::nullopt;
  made.type(ros::PARAMETER_STRING);
  made.string_value(value.get<std::string>());
  return made;
}

}  // namespace tocsin::foxglove
