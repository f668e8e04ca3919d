// SPDX-License-Identifier: Apache-2.0
#include "profile_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/spelling.hpp"
#include "idl_support/topic_registry.hpp"
#include "policy_values.hpp"
#include "runtime/middleware/idl_libraries.hpp"

namespace tocsin::qos_tool {
namespace {

std::string line_of(const QosProfile& profile) {
  std::vector<std::string> parts;
  for (const PolicyValue& one : values_of(profile)) {
    if (!one.is_default) parts.push_back(one.policy + ": " + one.value);
  }
  return "{" + joined(parts) + "}";
}

std::vector<std::string> topics_of(const std::string& profile, const std::vector<TopicUse>& uses) {
  std::vector<std::string> topics;
  for (const TopicUse& use : uses) {
    if (use.profile == profile) topics.push_back(use.topic + (use.crosses_link ? " (link)" : ""));
  }
  std::sort(topics.begin(), topics.end());
  return topics;
}

std::string topics_line(const std::vector<std::string>& topics) {
  return topics.empty() ? "no topic of the installed libraries" : joined(topics);
}

nlohmann::json json_of(const QosProfile& profile) {
  nlohmann::json policies = nlohmann::json::object();
  for (const PolicyValue& one : values_of(profile)) {
    policies[one.policy] = {{"value", one.value}, {"default", one.is_default}};
  }
  return policies;
}

}  // namespace

std::vector<TopicUse> known_uses() {
  load_idl_libraries();
  std::vector<TopicUse> uses;
  for (const KnownTopic& one : known_topics()) {
    uses.push_back({one.info.name, one.info.qos, one.info.scope == Scope::link});
  }
  return uses;
}

const QosProfile& find_profile(const QosProfiles& profiles, const std::string& name) {
  const auto found = profiles.all().find(name);
  if (found != profiles.all().end()) return found->second;
  std::vector<std::string> names;
  for (const auto& one : profiles.all()) names.push_back(one.first);
  throw ConfigError("'" + name + "' is not a profile of " + profiles.path() +
                    did_you_mean(names, name, "it has"));
}

std::string list_text(const QosProfiles& profiles, const std::vector<TopicUse>& uses) {
  std::string text;
  for (const auto& [name, profile] : profiles.all()) {
    text +=
        fmt::format("{}: {}\n  {}\n", name, line_of(profile), topics_line(topics_of(name, uses)));
  }
  return text;
}

nlohmann::json list_json(const QosProfiles& profiles, const std::vector<TopicUse>& uses) {
  nlohmann::json all = nlohmann::json::array();
  for (const auto& [name, profile] : profiles.all()) {
    nlohmann::json topics = nlohmann::json::array();
    for (const TopicUse& use : uses) {
      if (use.profile == name) topics.push_back({{"name", use.topic}, {"link", use.crosses_link}});
    }
    all.push_back({{"profile", name}, {"policies", json_of(profile)}, {"topics", topics}});
  }
  return all;
}

std::string show_text(const std::string& name, const QosProfile& profile, bool all) {
  if (!all) return name + ": " + line_of(profile) + "\n";
  std::string text = name + ":\n";
  for (const PolicyValue& one : values_of(profile)) {
    const std::string value = one.value.empty() ? "''" : one.value;
    text += fmt::format("  {}: {}{}\n", one.policy, value, one.is_default ? "  # default" : "");
  }
  return text;
}

nlohmann::json show_json(const std::string& name, const QosProfile& profile) {
  return {{"profile", name}, {"policies", json_of(profile)}};
}

std::string explain_text(const std::string& name, const QosProfile& profile,
                         const std::vector<TopicUse>& uses) {
  std::string text = fmt::format("{}, of {}\n", name, topics_line(topics_of(name, uses)));
  for (const PolicyValue& one : values_of(profile)) {
    const std::string value = one.value.empty() ? "none" : one.value;
    text += fmt::format("  {} {}{}: {}\n", one.policy, value, one.is_default ? " (default)" : "",
                        one.meaning);
  }
  return text;
}

std::string diff_text(const QosProfile& one, const QosProfile& other) {
  const auto ones = values_of(one);
  const auto others = values_of(other);
  std::string text;
  for (std::size_t i = 0; i < ones.size(); ++i) {
    if (ones[i].value == others[i].value) continue;
    text += fmt::format("{}: {} -> {}\n  {}\n", ones[i].policy, ones[i].value, others[i].value,
                        ones[i].meaning);
  }
  return text.empty() ? "no difference\n" : text;
}

nlohmann::json diff_json(const QosProfile& one, const QosProfile& other) {
  const auto ones = values_of(one);
  const auto others = values_of(other);
  nlohmann::json differences = nlohmann::json::object();
  for (std::size_t i = 0; i < ones.size(); ++i) {
    if (ones[i].value == others[i].value) continue;
    differences[ones[i].policy] = {ones[i].value, others[i].value};
  }
  return differences;
}

}  // namespace tocsin::qos_tool
