// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

namespace tocsin {

/// What the gate does with new samples while the link is poor.
enum class WhilePoor {
  send,    ///< never paused
  latest,  ///< keep the newest, send it on resume
  drop,    ///< count them
};

struct TrafficRule {
  std::string traffic_class;
  WhilePoor while_poor = WhilePoor::send;
};

/// A file such as config/traffic.yaml for one role: which class each link topic is in. It may
/// `extends` others; a topic that it names leaves the class that it has there. A bare name that is
/// not beside it is a file of share/config.
class TrafficRules {
 public:
  /// Without a file: everything is in no class and never paused.
  TrafficRules() = default;
  /// Throws ConfigError with file and line: unreadable file, unknown role or key, a topic named
  /// twice.
  TrafficRules(const std::string& path, const std::string& role);
  /// Throws ConfigError when the role's rules do not name the topic.
  [[nodiscard]] const TrafficRule& of(const std::string& topic) const;
  /// By topic.
  [[nodiscard]] const std::map<std::string, TrafficRule>& all() const { return rules_; }

 private:
  std::string path_;  ///< empty: without a file
  std::string role_;
  std::map<std::string, TrafficRule> rules_;
};

}  // namespace tocsin
