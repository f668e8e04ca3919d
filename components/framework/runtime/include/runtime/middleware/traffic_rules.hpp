// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "foundation/role.hpp"
#include "foundation/traffic_class.hpp"

namespace tocsin {

/// What the gate does with new samples while the link is poor.
enum class WhilePoor {
  send,    ///< never paused
  latest,  ///< keep the newest, send it on resume
  drop,    ///< count them
};

struct TrafficRule {
  TrafficClass traffic_class = TrafficClass::normal;
  WhilePoor while_poor = WhilePoor::send;
  bool adaptive = false;   ///< its writer follows the link's budget
  double min_rate_hz = 0;  ///< [1/s] may be thinned to this while the budget is short; 0: never
  bool stored = false;     ///< what does not cross at first is kept in a log and filled in later
};

/// A file such as config/traffic.yaml for one role: which class each link topic is in, and the DSCP
/// of each class. It may `extends` others; a topic that it names leaves the class that it has
/// there. A bare name that is not beside it is a file of share/config.
class TrafficRules {
 public:
  /// Without a file: everything is of class normal and never paused.
  TrafficRules() = default;
  /// Throws ConfigError with file and line: unreadable file, no map for the role, unknown class or
  /// key, a DSCP above 63, a topic named twice.
  TrafficRules(const std::string& path, Role role);
  /// Throws ConfigError when the role's rules do not name the topic.
  [[nodiscard]] const TrafficRule& of(const std::string& topic) const;
  /// By topic.
  [[nodiscard]] const std::map<std::string, TrafficRule>& all() const { return rules_; }
  /// Of the packets of a class, 0 to 63: the same for all roles of the file.
  [[nodiscard]] std::uint8_t dscp(TrafficClass traffic_class) const {
    return dscp_.of(traffic_class);
  }

 private:
  std::string path_;  ///< empty: without a file
  Role role_ = Role::uxv;
  std::map<std::string, TrafficRule> rules_;
  DscpOfClass dscp_;
};

}  // namespace tocsin
