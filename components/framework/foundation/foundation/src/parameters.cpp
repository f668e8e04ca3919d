// SPDX-License-Identifier: Apache-2.0
#include "foundation/parameters.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <set>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin {
namespace {

std::string range_text(Range range) {
  return "[" + shortest_text(range.min) + ", " + shortest_text(range.max) + "]";
}

std::string choices_text(Choices allowed) { return fmt::to_string(fmt::join(allowed, ", ")); }

std::string list_text(const std::vector<std::string>& items) { return "[" + joined(items) + "]"; }

std::string quoted(const YAML::Node& node) {
  return "'" + (node.IsScalar() ? printable(node.Scalar()) : "(not a scalar)") + "'";
}

bool inside(double value, Range range) { return value >= range.min && value <= range.max; }

}  // namespace

struct ParameterLoader::State {
  YAML::Node node;
  std::string owner;
  YamlSources sources;
  std::set<std::string> named;
  std::vector<std::string> order;

  /// The node of `name`, or an undefined node when the key is absent.
  YAML::Node find(const char* name) {
    named.insert(name);
    order.emplace_back(name);
    const YAML::Node& map = node;  // the const operator[] does not add the key
    return map.IsMap() ? map[name] : YAML::Node(YAML::NodeType::Undefined);
  }
};

ParameterLoader::ParameterLoader(const YAML::Node& node, std::string owner, YamlSources sources)
    : state_(std::make_unique<State>()) {
  if (node.IsDefined()) state_->node.reset(node);  // not a clone: a clone forgets its lines
  state_->owner = std::move(owner);
  state_->sources = std::move(sources);
  if (node.IsDefined() && !node.IsNull() && !node.IsMap()) {
    throw ConfigError(state_->owner + ": must be a map of parameters" +
                      yaml_place(state_->sources, node));
  }
}

ParameterLoader::~ParameterLoader() = default;

void ParameterLoader::fail(const char* name, const std::string& what) const {
  throw ConfigError(state_->owner + "." + name + ": " + what +
                    yaml_place(state_->sources, state_->node[name]));
}

void ParameterLoader::operator()(const char* name, double& value, Range range, const char*) {
  const YAML::Node found = state_->find(name);
  if (!found.IsDefined()) return;
  double read = NAN;
  if (!found.IsScalar() || !YAML::convert<double>::decode(found, read)) {
    fail(name, quoted(found) + " is not a number");
  }
  if (!inside(read, range)) fail(name, shortest_text(read) + " is outside " + range_text(range));
  value = read;
}

void ParameterLoader::operator()(const char* name, int& value, Range range, const char* text) {
  double read = value;
  (*this)(name, read, range, text);
  if (read != std::floor(read)) fail(name, shortest_text(read) + " is not a whole number");
  value = static_cast<int>(read);
}

void ParameterLoader::operator()(const char* name, bool& value, const char*) {
  const YAML::Node found = state_->find(name);
  if (!found.IsDefined()) return;
  if (!found.IsScalar() || !YAML::convert<bool>::decode(found, value)) {
    fail(name, quoted(found) + " is neither true nor false");
  }
}

void ParameterLoader::operator()(const char* name, std::string& value, const char*) {
  const YAML::Node found = state_->find(name);
  if (!found.IsDefined()) return;
  if (!found.IsScalar()) fail(name, "is not a text");
  value = found.Scalar();
}

void ParameterLoader::operator()(const char* name, std::string& value, Choices allowed,
                                 const char* text) {
  (*this)(name, value, text);
  for (const char* word : allowed) {
    if (value == word) return;
  }
  fail(name, "'" + printable(value) + "' is not one of: " + choices_text(allowed) +
                 suggestion({allowed.begin(), allowed.end()}, value));
}

void ParameterLoader::operator()(const char* name, std::vector<double>& value, Range range,
                                 const char*) {
  const YAML::Node found = state_->find(name);
  if (!found.IsDefined()) return;
  if (!found.IsSequence()) fail(name, "is not a list of numbers");
  std::vector<double> read;
  for (const YAML::Node& item : found) {
    double number = NAN;
    if (!item.IsScalar() || !YAML::convert<double>::decode(item, number)) {
      fail(name, "has an element that is not a number");
    }
    if (!inside(number, range))
      fail(name, shortest_text(number) + " is outside " + range_text(range));
    read.push_back(number);
  }
  value = std::move(read);
}

void ParameterLoader::operator()(const char* name, std::vector<std::string>& value, const char*) {
  const YAML::Node found = state_->find(name);
  if (!found.IsDefined()) return;
  if (!found.IsSequence()) fail(name, "is not a list of texts");
  std::vector<std::string> read;
  for (const YAML::Node& item : found) {
    if (!item.IsScalar()) fail(name, "has an element that is not a text");
    read.push_back(item.Scalar());
  }
  value = std::move(read);
}

void ParameterLoader::reject_unknown_keys() const {
  if (!state_->node.IsMap()) return;
  for (const auto& entry : state_->node) {
    const std::string key = entry.first.Scalar();
    if (state_->named.count(key) != 0) continue;
    throw ConfigError(state_->owner + "." + key +
                      ": unknown key; allowed: " + list_text(state_->order) +
                      suggestion(state_->order, key) + yaml_place(state_->sources, entry.first));
  }
}

std::string with_place(const std::string& text, const YAML::Node& node,
                       const YamlSources& sources) {
  if (!node.IsMap() || text.empty() || text.back() == ')') return text;
  const std::string subject = text.substr(0, text.find(':'));
  const std::string key = subject.substr(subject.rfind('.') + 1);  // all of it without a dot
  for (const auto& entry : node) {
    const bool is_value = entry.second.IsScalar() && entry.second.Scalar() == subject;
    if (entry.first.Scalar() == key) return text + yaml_place(sources, entry.first);
    if (is_value) {
      return text + " (" + entry.first.Scalar() + ", " + sources.place(entry.first) + ")";
    }
  }
  return text;
}

void ParameterPrinter::line(const char* name, const std::string& value, const std::string& allowed,
                            const char* text) {
  text_ += std::string(name) + ": " + value + "  # " + text;
  if (!allowed.empty()) text_ += "; " + allowed;
  if (next_is_live_) text_ += "; live";
  next_is_live_ = false;
  text_ += "\n";
}

void ParameterPrinter::operator()(const char* name, const double& value, Range range,
                                  const char* text) {
  line(name, shortest_text(value), "range " + range_text(range), text);
}

void ParameterPrinter::operator()(const char* name, const int& value, Range range,
                                  const char* text) {
  line(name, std::to_string(value), "range " + range_text(range), text);
}

void ParameterPrinter::operator()(const char* name, const bool& value, const char* text) {
  line(name, value ? "true" : "false", "", text);
}

void ParameterPrinter::operator()(const char* name, const std::string& value, const char* text) {
  line(name, value.empty() ? "\"\"" : value, "", text);
}

void ParameterPrinter::operator()(const char* name, const std::string& value, Choices allowed,
                                  const char* text) {
  line(name, value, "one of " + choices_text(allowed), text);
}

void ParameterPrinter::operator()(const char* name, const std::vector<double>& value, Range range,
                                  const char* text) {
  std::vector<std::string> items;
  for (const double number : value) items.push_back(shortest_text(number));
  line(name, list_text(items), "each in " + range_text(range), text);
}

void ParameterPrinter::operator()(const char* name, const std::vector<std::string>& value,
                                  const char* text) {
  line(name, list_text(value), "", text);
}

}  // namespace tocsin
