// SPDX-License-Identifier: Apache-2.0
#include "policy_settings.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/parameters.hpp"
#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::tools {
namespace {

using decision::PolicyParams;

/// The names of a parameter struct.
class Names {
 public:
  template <class Value>
  void operator()(const char* name, const Value&, Range, const char*) {
    all_.emplace_back(name);
  }
  template <class Value>
  void operator()(const char* name, const Value&, Choices, const char*) {
    all_.emplace_back(name);
  }
  template <class Value>
  void operator()(const char* name, const Value&, const char*) {
    all_.emplace_back(name);
  }
  [[nodiscard]] const std::vector<std::string>& all() const { return all_; }

 private:
  std::vector<std::string> all_;
};

bool names(const YAML::Node& values, const char* key) {
  return values.IsDefined() && values.IsMap() && values[key].IsDefined();
}

/// A key of this source that another key of an earlier source would silence.
void forget_replaced(const YAML::Node& values, PolicyParams& params) {
  if ((names(values, "good_mean") || names(values, "good_sd")) && !names(values, "good_family")) {
    params.good_family = "normal";
    params.good_parameters.clear();
  }
  if ((names(values, "bad_mean") || names(values, "bad_sd")) && !names(values, "bad_family")) {
    params.bad_family = "normal";
    params.bad_parameters.clear();
  }
  if (names(values, "alpha")) params.false_alarm_samples = 0;
  if (names(values, "alpha") || names(values, "false_alarm_samples")) params.detector_threshold = 0;
  if (names(values, "reverse_alpha")) params.false_resume_samples = 0;
}

std::string value_text(const YAML::Node& value) {
  YAML::Emitter out;
  out << YAML::Flow << value;
  return printable(out.c_str());
}

/// Those parameters of `values` that a policy has.
ParameterSource source_of(const std::string& name, const YAML::Node& values) {
  Names known;
  PolicyParams{}.visit(known);
  ParameterSource source{name, {}};
  for (const std::string& key : known.all()) {
    if (names(values, key.c_str())) source.values.emplace_back(key, value_text(values[key]));
  }
  return source;
}

YAML::Node setting_of(const std::vector<std::string>& all) {
  YAML::Node values(YAML::NodeType::Map);
  for (const std::string& one : all) {
    const auto equals = one.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw ConfigError("--set: '" + printable(one) + "' must be key=value");
    }
    values[one.substr(0, equals)] =
        read_yaml_text(one.substr(equals + 1), "--set " + printable(one));
  }
  return values;
}

decision::PolicyKind policy_of(const std::string& name) {
  if (const auto kind = value_of<decision::PolicyKind>(name)) return *kind;
  const std::vector<std::string> known(decision::policy_names.begin(),
                                       decision::policy_names.end());
  throw ConfigError("--policy: '" + printable(name) + "' is not one of: " + joined(known, ", ") +
                    ", oracle" + suggestion(known, name));
}

/// Adds what is from one source. A run's controller has parameters besides those of its policy.
void add(const YAML::Node& values, const std::string& owner, const std::string& name,
         PolicySettings& settings) {
  forget_replaced(values, settings.params);
  ParameterLoader loader(values, owner, name);
  settings.params.visit(loader);
  if (owner == "policy") loader.reject_unknown_keys();
  settings.sources.push_back(source_of(name, values));
}

}  // namespace

PolicySettings load_settings(const PolicyRequest& request) {
  PolicySettings settings;
  if (request.run) {
    add(*request.run->values, "transmission_controller", request.run->file, settings);
    settings.sources.back().name +=
        ", transmission_controller of " + joined_roles(request.run->roles);
  }
  if (!request.model.empty()) {
    add(read_yaml_file(request.model), "policy", request.model, settings);
  }
  if (!request.set.empty()) add(setting_of(request.set), "policy", "--set", settings);
  if (!request.policy.empty()) {
    if (request.policy != "oracle") settings.params.policy = policy_of(request.policy);
    settings.sources.push_back({"--policy", {{"policy", request.policy}}});
  }
  return settings;
}

bool names_policy(const PolicySettings& settings) {
  return std::any_of(settings.sources.begin(), settings.sources.end(), [](const auto& source) {
    return std::any_of(source.values.begin(), source.values.end(),
                       [](const auto& value) { return value.first == "policy"; });
  });
}

std::string to_text(const PolicySettings& settings) {
  std::string text;
  for (const ParameterSource& source : settings.sources) {
    text += "parameters from " + source.name + ":";
    for (const auto& [key, value] : source.values) {
      text += (&key == &source.values.front().first ? " " : ", ") + key + " " + value;
    }
    text += source.values.empty() ? " none\n" : "\n";
  }
  return text + (settings.sources.empty() ? "all parameters are the defaults\n"
                                          : "all other parameters are the defaults\n");
}

std::string source_names(const PolicySettings& settings) {
  if (settings.sources.empty()) return "the defaults";
  return joined_of(settings.sources, [](const ParameterSource& source) { return source.name; });
}

}  // namespace tocsin::tools
