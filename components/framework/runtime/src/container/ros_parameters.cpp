// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/ros_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"

namespace tocsin {
namespace {

namespace type = rcl_interfaces::msg::ParameterType_Constants;

/// Fills a message by what the value is.
struct Filler {
  RosValue& value;
  void operator()(bool given) const {
    value.type(type::PARAMETER_BOOL);
    value.bool_value(given);
  }
  void operator()(std::int64_t given) const {
    value.type(type::PARAMETER_INTEGER);
    value.integer_value(given);
  }
  void operator()(double given) const {
    value.type(type::PARAMETER_DOUBLE);
    value.double_value(given);
  }
  void operator()(const std::string& given) const {
    value.type(type::PARAMETER_STRING);
    value.string_value(given);
  }
  void operator()(const std::vector<double>& given) const {
    value.type(type::PARAMETER_DOUBLE_ARRAY);
    value.double_array_value(given);
  }
  void operator()(const std::vector<std::string>& given) const {
    value.type(type::PARAMETER_STRING_ARRAY);
    value.string_array_value(given);
  }
};

/// Steps of 0: any value between.
void add_range(const ParameterFacts& facts, rcl_interfaces::msg::ParameterDescriptor& described) {
  if (!facts.range) return;
  if (described.type() == type::PARAMETER_INTEGER) {
    constexpr double most = 9.2e18;  // of 64 bits
    rcl_interfaces::msg::IntegerRange range;
    range.from_value(std::llround(std::clamp(facts.range->min, -most, most)));
    range.to_value(std::llround(std::clamp(facts.range->max, -most, most)));
    described.integer_range().push_back(range);
    return;
  }
  rcl_interfaces::msg::FloatingPointRange range;
  range.from_value(facts.range->min);
  range.to_value(facts.range->max);
  described.floating_point_range().push_back(range);
}

std::size_t parts_in(const std::string& name) {
  return 1 + static_cast<std::size_t>(std::count(name.begin(), name.end(), '.'));
}

/// What follows `prefix` and a dot in the name; all of it for no prefix; empty: it does not begin
/// so.
std::string below(const std::string& name, const std::string& prefix) {
  if (prefix.empty() || name == prefix) return name;
  const std::string start = prefix + ".";
  return name.compare(0, start.size(), start) == 0 ? name.substr(start.size()) : "";
}

bool is_wanted(const std::string& name,
               const rcl_interfaces::srv::ListParameters_Request& request) {
  const auto fits = [&](const std::string& prefix) {
    const std::string rest = below(name, prefix);
    return !rest.empty() && (request.depth() == 0 || parts_in(rest) <= request.depth());
  };
  const auto& prefixes = request.prefixes();
  return prefixes.empty() ? fits("") : std::any_of(prefixes.begin(), prefixes.end(), fits);
}

bool is_empty_list(const RosValue& value) {
  switch (value.type()) {
    case type::PARAMETER_BOOL_ARRAY:
      return value.bool_array_value().empty();
    case type::PARAMETER_INTEGER_ARRAY:
      return value.integer_array_value().empty();
    case type::PARAMETER_DOUBLE_ARRAY:
      return value.double_array_value().empty();
    case type::PARAMETER_STRING_ARRAY:
      return value.string_array_value().empty();
    default:
      return false;
  }
}

/// A number, whole or not; nothing of another value.
std::optional<double> number_in(const RosValue& value) {
  if (value.type() == type::PARAMETER_INTEGER) return static_cast<double>(value.integer_value());
  if (value.type() == type::PARAMETER_DOUBLE) return value.double_value();
  return std::nullopt;
}

/// The same of a list.
std::optional<std::vector<double>> numbers_in(const RosValue& value) {
  const auto& whole = value.integer_array_value();
  if (value.type() == type::PARAMETER_INTEGER_ARRAY) return {{whole.begin(), whole.end()}};
  if (value.type() == type::PARAMETER_DOUBLE_ARRAY) return value.double_array_value();
  return std::nullopt;
}

/// Adds to the array of the type that the first item has.
void add(RosValue& list, const ParameterValue& item) {
  if (const auto* text = std::get_if<std::string>(&item)) {
    list.type(type::PARAMETER_STRING_ARRAY);
    list.string_array_value().push_back(*text);
  } else if (const auto* number = std::get_if<double>(&item)) {
    list.type(type::PARAMETER_DOUBLE_ARRAY);
    list.double_array_value().push_back(*number);
  } else if (const auto* whole = std::get_if<std::int64_t>(&item)) {
    list.type(type::PARAMETER_INTEGER_ARRAY);
    list.integer_array_value().push_back(*whole);
  } else if (const auto* truth = std::get_if<bool>(&item)) {
    list.type(type::PARAMETER_BOOL_ARRAY);
    list.bool_array_value().push_back(*truth);
  }
}

RosValue list_in(const YAML::Node& node, const std::string& shown) {
  RosValue list;
  std::size_t kind = 0;
  for (const YAML::Node& one : node) {
    if (!one.IsScalar()) throw ConfigError(shown + ": must be a list of numbers, texts or truths");
    const ParameterValue item = scalar_of(one);
    if (list.type() != type::PARAMETER_NOT_SET && item.index() != kind) {
      throw ConfigError(shown + ": has elements of several types");
    }
    kind = item.index();
    add(list, item);
  }
  if (list.type() == type::PARAMETER_NOT_SET) list.type(type::PARAMETER_STRING_ARRAY);
  return list;
}

}  // namespace

RosValue ros_value(const ParameterValue& value) {
  RosValue made;
  std::visit(Filler{made}, value);
  return made;
}

std::optional<YAML::Node> yaml_of(const RosValue& value) {
  switch (value.type()) {
    case type::PARAMETER_BOOL:
      return YAML::Node(value.bool_value());
    case type::PARAMETER_INTEGER:
      return YAML::Node(value.integer_value());
    case type::PARAMETER_DOUBLE:
      return YAML::Node(value.double_value());
    case type::PARAMETER_STRING:
      return YAML::Node(value.string_value());
    case type::PARAMETER_INTEGER_ARRAY:
      return YAML::Node(value.integer_array_value());
    case type::PARAMETER_DOUBLE_ARRAY:
      return YAML::Node(value.double_array_value());
    case type::PARAMETER_STRING_ARRAY:
      return YAML::Node(value.string_array_value());
    default:
      return std::nullopt;
  }
}

ParameterValue scalar_of(const YAML::Node& node) {
  constexpr const char* quoted_tag = "!";
  std::int64_t whole = 0;
  double number = 0;
  bool truth = false;
  if (node.Tag() == quoted_tag) return node.Scalar();
  if (YAML::convert<std::int64_t>::decode(node, whole)) return whole;
  if (YAML::convert<double>::decode(node, number)) return number;
  // `y` and `n` are texts, as in Python's YAML.
  if (node.Scalar().size() > 1 && YAML::convert<bool>::decode(node, truth)) return truth;
  return node.Scalar();
}

RosValue ros_value_of(const YAML::Node& node, const std::string& shown) {
  if (node.IsNull()) return ros_value(std::string());
  if (node.IsSequence()) return list_in(node, shown);
  if (!node.IsScalar()) throw ConfigError(shown + ": must be a value or a list");
  return ros_value(scalar_of(node));
}

const char* type_word(std::uint8_t code) {
  static constexpr std::array<const char*, 10> words{
      "not set",    "boolean",       "integer",       "double",       "string",
      "byte array", "boolean array", "integer array", "double array", "string array"};
  return code < words.size() ? words[code] : "unknown";
}

std::string type_fault(const ParameterValue& has, const RosValue& given) {
  const std::uint8_t wanted = ros_value(has).type();
  const bool whole = given.type() == type::PARAMETER_INTEGER && wanted == type::PARAMETER_DOUBLE;
  const bool all_whole =
      given.type() == type::PARAMETER_INTEGER_ARRAY && wanted == type::PARAMETER_DOUBLE_ARRAY;
  if (given.type() == wanted || whole || all_whole) return "";
  return fmt::format("is of type {}, not {}", type_word(wanted), type_word(given.type()));
}

bool has_value(const ParameterValue& has, const RosValue& given) {
  if (const auto* numbers = std::get_if<std::vector<double>>(&has)) {
    return is_empty_list(given) ? numbers->empty() : numbers_in(given) == *numbers;
  }
  if (const auto* texts = std::get_if<std::vector<std::string>>(&has)) {
    return is_empty_list(given) ? texts->empty()
                                : given.type() == type::PARAMETER_STRING_ARRAY &&
                                      given.string_array_value() == *texts;
  }
  if (const auto* number = std::get_if<double>(&has)) {
    const auto other = number_in(given);
    return other && (std::isnan(*number) ? std::isnan(*other) : *other == *number);
  }
  return ros_value(has) == given;
}

rcl_interfaces::msg::ParameterDescriptor describe(const ParameterFacts& facts) {
  rcl_interfaces::msg::ParameterDescriptor described;
  described.name(facts.name);
  described.type(ros_value(facts.value).type());
  described.description(facts.text);
  described.read_only(!facts.live);
  if (!facts.choices.empty()) {
    described.additional_constraints("one of: " + joined(facts.choices, ", "));
  }
  add_range(facts, described);
  return described;
}

rcl_interfaces::msg::ListParametersResult list_parameters(
    const std::vector<ParameterFacts>& all,
    const rcl_interfaces::srv::ListParameters_Request& request) {
  rcl_interfaces::msg::ListParametersResult result;
  std::set<std::string> prefixes;
  for (const ParameterFacts& one : all) {
    if (!is_wanted(one.name, request)) continue;
    result.names().push_back(one.name);
    const std::size_t dot = one.name.rfind('.');
    if (dot != std::string::npos) prefixes.insert(one.name.substr(0, dot));
  }
  result.prefixes().assign(prefixes.begin(), prefixes.end());
  return result;
}

const ParameterFacts* find_parameter(const std::vector<ParameterFacts>& all,
                                     const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const ParameterFacts& one) { return one.name == name; });
  return found != all.end() ? &*found : nullptr;
}

}  // namespace tocsin
