// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/qos_change.hpp"

#include <algorithm>
#include <map>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/spelling.hpp"
#include "foundation/yaml_file.hpp"
#include "foundation/yaml_sources.hpp"

namespace tocsin {
namespace {

constexpr const char* by_specification =
    "DDS fixes it when an end is made; change the profile and start the process again";
constexpr const char* ignored =
    "Fast DDS 2.9.1 takes a new value and goes on with the old one; change the profile and start "
    "the process again";
constexpr const char* of_runtime =
    "the runtime makes room for it when an end is made; change the profile and start the process "
    "again";

/// Tried on Fast DDS 2.9.1; what is not here can change.
const std::map<std::string, const char*>& fixed() {
  static const std::map<std::string, const char*> reasons{
      {"reliability", by_specification},
      {"durability", by_specification},
      {"liveliness", by_specification},
      {"liveliness_lease_s", by_specification},
      {"ownership", by_specification},
      {"history", by_specification},
      {"depth", by_specification},
      {"max_samples", by_specification},
      {"allocated_samples", by_specification},
      {"extra_samples", by_specification},
      {"requested_reliability", by_specification},
      {"memory_policy", of_runtime},
      {"max_blocking_time_s", ignored},
      {"initial_heartbeat_delay_s", ignored},
      {"heartbeat_period_s", ignored},
      {"nack_response_delay_s", ignored},
      {"nack_suppression_s", ignored},
      {"heartbeat_piggyback", ignored},
      {"initial_acknack_delay_s", ignored},
      {"heartbeat_response_delay_s", ignored},
      {"liveliness_announcement_s", ignored},
      {"publish_mode", ignored},
      {"user_data", "it tells the layout of the topic's type, by which samples are refused"},
  };
  return reasons;
}

/// Collects the names of the policies of a profile.
struct PolicyNames {
  std::vector<std::string> names;
  template <class Value>
  void operator()(const char* name, Value&, const char*) {
    names.emplace_back(name);
  }
  template <class Value>
  void operator()(const char* name, Value&, Range, const char*) {
    names.emplace_back(name);
  }
  void operator()(const char* name, std::string&, Choices, const char*) {
    names.emplace_back(name);
  }
};

std::vector<std::string> policies() {
  QosProfile profile;
  PolicyNames found;
  profile.visit(found);
  return found.names;
}

void refuse_what_cannot_change(const YAML::Node& settings) {
  const std::vector<std::string> known = policies();
  for (const auto& entry : settings) {
    const std::string key = entry.first.Scalar();
    const std::string unsupported = refusal(key, "");
    if (!unsupported.empty()) throw ConfigError(key + ": not supported: " + unsupported);
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      throw ConfigError("'" + key + "' is not a policy" +
                        did_you_mean(known, key, "those that can change are"));
    }
    const std::string why = why_fixed(key);
    if (why.empty()) continue;
    throw ConfigError(key + ": cannot change while the system runs: " + why +
                      "; what can change: " + joined(changeable_policies()));
  }
}

}  // namespace

std::string why_fixed(const std::string& policy) {
  const auto found = fixed().find(policy);
  return found != fixed().end() ? found->second : "";
}

std::vector<std::string> changeable_policies() {
  std::vector<std::string> all = policies();
  all.erase(std::remove_if(all.begin(), all.end(),
                           [](const std::string& one) { return !why_fixed(one).empty(); }),
            all.end());
  return all;
}

namespace {

/// `profile` with the settings, whether they agree with the rest of it or not.
QosProfile with(const QosProfile& profile, const std::string& settings) {
  YamlSources sources;
  const YAML::Node node = sources.parse(settings, "the settings");
  if (!node.IsMap() || node.size() == 0) {
    throw ConfigError("nothing to change: give policy=value; what can change: " +
                      joined(changeable_policies()));
  }
  refuse_what_cannot_change(node);
  QosProfile result = profile;
  ParameterLoader loader(node, "qos", sources);
  result.visit(loader);
  return result;
}

}  // namespace

void check_change(const std::string& settings) { (void)with({}, settings); }

QosProfile changed(const QosProfile& profile, const std::string& settings) {
  const QosProfile result = with(profile, settings);
  if (const auto broken = conflict(result)) {
    throw ConfigError(broken->policy + ": " + broken->reason);
  }
  return result;
}

}  // namespace tocsin
