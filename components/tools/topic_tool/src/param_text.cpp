// SPDX-License-Identifier: Apache-2.0
#include "param_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/printable.hpp"
#include "foundation/yaml_sources.hpp"
#include "python_float.hpp"

namespace tocsin::topic_tool {
namespace {

namespace codes = rcl_interfaces::msg::ParameterType_Constants;

std::string python_quoted(const std::string& text) { return "'" + printable(text) + "'"; }

template <class List, class Text>
std::string list_text(const List& list, const Text& text) {
  std::vector<std::string> items;
  for (const auto& one : list) items.push_back(text(one));
  return "[" + joined(items) + "]";
}

bool is_array(const RosValue& value) { return value.type() >= codes::PARAMETER_BYTE_ARRAY; }

/// The narrowest of integer, double, boolean and string that the scalar is.
ParameterValue scalar_in(const YAML::Node& node) {
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

/// Adds to the array of the type that the first item has.
void add(RosValue& list, const ParameterValue& item) {
  if (const auto* text = std::get_if<std::string>(&item)) {
    list.type(codes::PARAMETER_STRING_ARRAY);
    list.string_array_value().push_back(*text);
  } else if (const auto* number = std::get_if<double>(&item)) {
    list.type(codes::PARAMETER_DOUBLE_ARRAY);
    list.double_array_value().push_back(*number);
  } else if (const auto* whole = std::get_if<std::int64_t>(&item)) {
    list.type(codes::PARAMETER_INTEGER_ARRAY);
    list.integer_array_value().push_back(*whole);
  } else if (const auto* truth = std::get_if<bool>(&item)) {
    list.type(codes::PARAMETER_BOOL_ARRAY);
    list.bool_array_value().push_back(*truth);
  }
}

RosValue list_in(const YAML::Node& node, const std::string& shown) {
  RosValue list;
  std::size_t kind = 0;
  for (const YAML::Node& one : node) {
    if (!one.IsScalar()) throw ConfigError(shown + ": must be a list of numbers, texts or truths");
    const ParameterValue item = scalar_in(one);
    if (list.type() != codes::PARAMETER_NOT_SET && item.index() != kind) {
      throw ConfigError(shown + ": has elements of several types");
    }
    kind = item.index();
    add(list, item);
  }
  if (list.type() == codes::PARAMETER_NOT_SET) list.type(codes::PARAMETER_STRING_ARRAY);
  return list;
}

RosValue value_of_node(const YAML::Node& node, const std::string& shown) {
  if (node.IsSequence()) return list_in(node, shown);
  if (!node.IsScalar()) throw ConfigError(shown + ": must be a value or a list");
  return ros_value(scalar_in(node));
}

/// The value of a key; null when there is none.
YAML::Node map_of(const YAML::Node& node, const std::string& key) {
  if (!node.IsMap()) return {};
  const YAML::Node found = node[key];
  return found.IsDefined() ? found : YAML::Node();
}

/// Names of maps in maps are joined by dots.
void collect(const YAML::Node& map, const std::string& prefix, std::vector<NamedValue>& values) {
  for (const auto& entry : map) {
    const std::string name = prefix + entry.first.Scalar();
    if (entry.second.IsMap()) {
      collect(entry.second, name + ".", values);
    } else {
      values.emplace_back(name, value_of_node(entry.second, name));
    }
  }
}

}  // namespace

std::string value_text(const RosValue& value) {
  switch (value.type()) {
    case codes::PARAMETER_BOOL:
      return value.bool_value() ? "True" : "False";
    case codes::PARAMETER_INTEGER:
      return std::to_string(value.integer_value());
    case codes::PARAMETER_DOUBLE:
      return python_float(value.double_value());
    case codes::PARAMETER_STRING:
      return printable(value.string_value());
    case codes::PARAMETER_BOOL_ARRAY:
      return list_text(value.bool_array_value(), [](bool one) { return one ? "True" : "False"; });
    case codes::PARAMETER_INTEGER_ARRAY:
      return list_text(value.integer_array_value(), [](auto one) { return std::to_string(one); });
    case codes::PARAMETER_DOUBLE_ARRAY:
      return list_text(value.double_array_value(), python_float<double>);
    case codes::PARAMETER_STRING_ARRAY:
      return list_text(value.string_array_value(), python_quoted);
    default:
      return "";
  }
}

std::string typed_value_text(const RosValue& value) {
  if (value.type() == codes::PARAMETER_NOT_SET) return "Parameter not set.";
  std::string word = type_word(value.type());
  const std::size_t array = word.find(" array");
  if (array != std::string::npos) word.resize(array);
  word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
  return word + (is_array(value) ? " values are: " : " value is: ") + value_text(value);
}

std::string description_text(const rcl_interfaces::msg::ParameterDescriptor& descriptor) {
  std::string text = fmt::format("Parameter name: {}\n  Type: {}\n", printable(descriptor.name()),
                                 type_word(descriptor.type()));
  if (!descriptor.description().empty()) {
    text += fmt::format("  Description: {}\n", printable(descriptor.description()));
  }
  text += "  Constraints:\n";
  if (descriptor.read_only()) text += "    Read only: true\n";
  for (const auto& range : descriptor.floating_point_range()) {
    text += fmt::format("    Min value: {}\n    Max value: {}\n", python_float(range.from_value()),
                        python_float(range.to_value()));
  }
  for (const auto& range : descriptor.integer_range()) {
    text +=
        fmt::format("    Min value: {}\n    Max value: {}\n", range.from_value(), range.to_value());
  }
  if (!descriptor.additional_constraints().empty()) {
    text += fmt::format("    Additional constraints: {}\n",
                        printable(descriptor.additional_constraints()));
  }
  return text;
}

std::string dump_text(const std::string& node, const std::vector<NamedValue>& values) {
  YAML::Emitter out;
  out << YAML::BeginMap << YAML::Key << node << YAML::Value << YAML::BeginMap << YAML::Key
      << "ros__parameters" << YAML::Value << YAML::BeginMap;
  for (const auto& [name, value] : values) {
    const auto yaml = yaml_of(value);
    if (!yaml) continue;
    out << YAML::Key << name << YAML::Value;
    if (value.type() == codes::PARAMETER_DOUBLE && std::isfinite(value.double_value())) {
      out << python_float(value.double_value());
    } else if (value.type() == codes::PARAMETER_STRING) {
      // What would be read as a number or a truth must not become one.
      const bool plain = std::holds_alternative<std::string>(scalar_in(*yaml));
      if (!plain) out << YAML::SingleQuoted;
      out << value.string_value();
    } else {
      out << YAML::Flow << *yaml;
    }
  }
  out << YAML::EndMap << YAML::EndMap << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

RosValue value_in(const std::string& yaml) {
  YamlSources sources;
  const YAML::Node node = sources.parse(yaml, "value");
  return node.IsNull() ? ros_value(std::string()) : value_of_node(node, "value");
}

std::vector<NamedValue> values_in_file(const std::string& file, const std::string& node) {
  YamlSources sources;
  const YAML::Node root = sources.read(file);
  std::vector<NamedValue> values;
  for (const std::string& key : {std::string("/**"), node}) {
    const YAML::Node map = map_of(map_of(root, key), "ros__parameters");
    if (map.IsMap()) collect(map, "", values);
  }
  if (values.empty()) {
    throw ConfigError(file + ": has no parameters for " + node + ", under ros__parameters of '" +
                      node + "' or '/**'");
  }
  return values;
}

}  // namespace tocsin::topic_tool
