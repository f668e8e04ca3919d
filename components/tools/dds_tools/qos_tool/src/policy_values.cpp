// SPDX-License-Identifier: Apache-2.0
#include "policy_values.hpp"

#include <fmt/core.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/yaml_sources.hpp"

namespace tocsin::qos_tool {
namespace {

/// Writes down what a profile visits.
struct Collector {
  std::vector<PolicyValue> values;

  void operator()(const char* policy, const double& value, Range, const char* text) {
    add(policy, seconds_text(value), text);
  }
  void operator()(const char* policy, const int& value, Range, const char* text) {
    add(policy, std::to_string(value), text);
  }
  void operator()(const char* policy, const bool& value, const char* text) {
    add(policy, value ? "true" : "false", text);
  }
  void operator()(const char* policy, const std::string& value, const char* text) {
    add(policy, value, text);
  }
  void operator()(const char* policy, const std::string& value, Choices, const char* text) {
    add(policy, value, text);
  }
  void operator()(const char* policy, const std::vector<std::string>& value, const char* text) {
    add(policy, list_text(value), text);
  }
  void add(const char* policy, std::string value, const char* text) {
    values.push_back({policy, std::move(value), false, text});
  }
};

std::vector<PolicyValue> collected(QosProfile profile) {
  Collector collector;
  profile.visit(collector);
  return std::move(collector.values);
}

}  // namespace

std::vector<PolicyValue> values_of(const QosProfile& profile) {
  std::vector<PolicyValue> values = collected(profile);
  const std::vector<PolicyValue> defaults = collected({});
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i].is_default = values[i].value == defaults[i].value;
  }
  return values;
}

Values value_map(const QosProfile& profile) {
  Values map;
  for (PolicyValue& one : collected(profile)) map[one.policy] = std::move(one.value);
  return map;
}

std::string list_text(const std::vector<std::string>& names) {
  YAML::Emitter out;
  out << YAML::Flow << YAML::BeginSeq;
  for (const std::string& name : names)
    out << (name.empty() ? YAML::DoubleQuoted : YAML::Auto) << name;
  out << YAML::EndSeq;
  return out.c_str();
}

std::vector<std::string> names_of(const std::string& list) {
  YamlSources sources;
  return sources.parse(list, "a list of names").as<std::vector<std::string>>();
}

std::string seconds_text(double s) { return std::isinf(s) ? ".inf" : fmt::format("{:.10g}", s); }

double seconds_of(const std::string& text) {
  YamlSources sources;
  return sources.parse(text, "a number of seconds").as<double>();
}

QosProfile effective(QosProfile profile) {
  profile.max_samples = profile.room();
  if (std::isinf(profile.liveliness_announcement_s)) {
    profile.liveliness_announcement_s = profile.liveliness_lease_s / 3;
  }
  return profile;
}

}  // namespace tocsin::qos_tool
