// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "foundation/yaml_sources.hpp"
#include "idl_support/topic_info.hpp"
#include "runtime/middleware/qos_policies.hpp"

namespace tocsin {

/// What a topic has in place of its profile's values.
struct TopicOverride {
  std::optional<double> max_rate_hz;
  std::optional<double> minimum_separation_s;
  std::string place;  ///< " (file:line)" of it, for error texts
};

/// The QoS file: profiles by name, and overrides by topic under `topics`. It may `extends` others,
/// key by key; a bare name that is not beside it is a file of share/config.
class QosProfiles {
 public:
  /// Without a file: the profiles of the shipped config/qos.yaml, in every partition.
  QosProfiles();
  /// Reads a file such as config/qos.yaml. Throws ConfigError with file and line.
  explicit QosProfiles(const std::string& path);
  /// The profile with the overrides of `topic`. Throws ConfigError naming the topic when the
  /// profile is missing or the overrides contradict it.
  [[nodiscard]] QosProfile of(const std::string& profile, const std::string& topic) const;
  /// As they stand in the file, by name.
  [[nodiscard]] const std::map<std::string, QosProfile>& all() const { return profiles_; }
  /// The file, or what stands for it in texts.
  [[nodiscard]] const std::string& path() const { return path_; }
  /// Topics that have overrides, for whoever knows which topics there are.
  [[nodiscard]] std::vector<std::string> overridden_topics() const;

 private:
  void read_profile(const std::string& name, const YAML::Node& node);
  void read_overrides(const YAML::Node& node);

  std::string path_;
  YamlSources sources_;
  std::map<std::string, QosProfile> profiles_;
  std::map<std::string, TopicOverride> overrides_;
};

/// Throws ConfigError when the writers of a topic that crosses the link would have owners.
void refuse_owners_on_link(const TopicInfo& topic, const QosContract& qos);

}  // namespace tocsin
