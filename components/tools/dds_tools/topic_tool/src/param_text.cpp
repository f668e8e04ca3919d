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
      values.emplace_back(name, ros_value_of(entry.second, name));
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
      const bool plain = std::holds_alternative<std::string>(scalar_of(*yaml));
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
  return ros_value_of(node, "value");
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
