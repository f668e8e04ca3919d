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

/// Shares a bound on bytes per period among the asynchronous writers that name it.
struct FlowController {
  std::string scheduler = "high_priority";
  int max_bytes_per_period = 0;
  double period_s = 0.01;

  template <class Visitor>
  void visit(Visitor& v) {
    v("scheduler", scheduler, {"fifo", "round_robin", "high_priority", "priority_with_reservation"},
      "who is sent next");
    v("max_bytes_per_period", max_bytes_per_period, {0, 2147483647},
      "[B] sent in a period; 0: unlimited");
    v("period_s", period_s, {0.001, 10}, "[s] a writer of high priority waits this long at most");
  }
};

/// What a topic has in place of its profile's values.
struct TopicOverride {
  std::optional<double> max_rate_hz;
  std::optional<double> minimum_separation_s;
  std::string place;  ///< " (file:line)" of it, for error texts
};

/// The QoS file: profiles by name, `flow_controllers`, and overrides by topic under `topics`. It
/// may `extends` others, key by key; a bare name that is not beside it is a file of share/config.
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
  [[nodiscard]] const std::map<std::string, FlowController>& flow_controllers() const {
    return flow_controllers_;
  }
  /// Topics that have overrides, for whoever knows which topics there are.
  [[nodiscard]] std::vector<std::string> overridden_topics() const;

 private:
  void read_profile(const std::string& name, const YAML::Node& node);
  void read_flow_controllers(const YAML::Node& node);
  void read_overrides(const YAML::Node& node);

  std::string path_;
  YamlSources sources_;
  std::map<std::string, QosProfile> profiles_;
  std::map<std::string, FlowController> flow_controllers_;
  std::map<std::string, TopicOverride> overrides_;
};

/// Throws ConfigError when the writers of a topic that crosses the link would have owners.
void refuse_owners_on_link(const TopicInfo& topic, const QosContract& qos);

}  // namespace tocsin
