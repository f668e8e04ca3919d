// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "foundation/role.hpp"
#include "foundation/traffic_class.hpp"
#include "runtime/detail/name_rules.hpp"

namespace tocsin {

/// Whose components stand before the wheels of a deployment's vehicle.
enum class VehicleChain {
  foreign,  ///< a robot that knows nothing of this stack: velocities may cross to it
  ours,     ///< what obeys the emergency stop runs there: nothing of the chain crosses
};

/// When which part of a host's log crosses without anybody asking. One of the list `fetch` of a
/// role in a traffic file.
struct FetchRule {
  std::string when;  ///< topic whose samples are looked at
  /// A number or truth (0 or 1) of its type, with dots: `twist.twist.linear.x`; a sample fulfils
  /// the rule when it is above `above` and below `below`. Empty: every sample does.
  std::string field;
  double above = 0;
  double below = std::numeric_limits<double>::infinity();
  std::vector<std::string> topics;  ///< what crosses: logged topics, or patterns
  double before_s = 10;             ///< [s] [0, 600] of the log before that sample
  double after_s = 10;              ///< [s] [0, 600] and after it
  /// [s] [0, 86400] Samples that fulfil it and come within this time of the last that did belong
  /// to the same event: for an event once.
  double min_interval_s = 5;
  std::string name;  ///< for error texts: `uxv.fetch[0]`
};

/// What the gate does with new samples while the link is poor.
enum class WhilePoor {
  send,    ///< never paused
  latest,  ///< keep the newest, send it on resume
  drop,    ///< count them
};

struct TrafficRule {
  TrafficClass traffic_class = TrafficClass::normal;
  WhilePoor while_poor = WhilePoor::send;
  bool adaptive = false;    ///< its writer follows the link's budget
  bool on_demand = false;   ///< crosses while somebody on the other side reads it
  bool stored = false;      ///< what does not cross at first is kept in a log and backfilled later
  bool logged = false;      ///< a log keeps it, and what did not cross does so when it is asked for
  bool compressed = false;  ///< crosses in fewer bytes where that gains something
  bool live = true;         ///< crosses as it is written; false: it is logged only
  double max_rate_hz = 0;   ///< [1/s] of each writer cross at most so many; 0: all
  int depth = 1;            ///< [1, 10000] newest samples of each writer that count
  /// Older samples do not cross; what their writer offers, if that is less.
  double lifespan_s = std::numeric_limits<double>::infinity();
};

/// Services that hosts of one role serve for the others in one class.
struct CallClass {
  Role server = Role::uxv;
  TrafficClass traffic_class = TrafficClass::normal;
  double deadline_s = 5;  ///< without a reply a call is given up then, but for an action's result
};

/// How calls of a service cross.
struct CallRule {
  CallClass how;
  /// It is shown to the peers' hosts while somebody there calls it, and not before: a pattern
  /// named it.
  bool on_demand = false;
};

/// The topics that one role sends over the link.
struct SentTopics {
  struct Stays {};
  NameRules<TrafficRule> rules;
  NameRules<Stays> stays;  ///< go before the patterns of rules
  /// Null: none fits, or the file says that it stays on its host.
  [[nodiscard]] const TrafficRule* find(const std::string& topic) const;
};

/// Of each class.
[[nodiscard]] std::array<PathUse, traffic_classes.size()> default_paths();

/// A file such as config/traffic.yaml for one role: which class each link topic is in, the DSCP and
/// the paths of each class, and which services and actions the sides serve each other. Names may be
/// patterns. It may `extends` others; a name leaves the class that it has there. A bare name that
/// is not beside it is a file of share/config.
class TrafficRules {
 public:
  /// Without a file: everything but the chain before the wheels crosses, of class normal and never
  /// paused.
  TrafficRules() = default;
  /// Throws ConfigError with file and line: unreadable file, no map for the role, unknown class or
  /// key, a DSCP above 63, a topic named twice, one that is both stored and logged, one that is
  /// kept and not in its class, a rule of `fetch` as fetch_rules() has it, and, where the chain is
  /// ours, a name or pattern by which a topic of the chain would cross.
  TrafficRules(const std::string& path, Role role, VehicleChain chain = VehicleChain::foreign);
  /// Throws ConfigError when no rule of the role fits the topic.
  [[nodiscard]] const TrafficRule& of(const std::string& topic) const;
  /// Null when no rule of the role fits the topic, the file says that it stays on its host, or it
  /// is of the chain, which may be logged only.
  [[nodiscard]] const TrafficRule* find(const std::string& topic) const;
  /// By topic, those of patterns left out.
  [[nodiscard]] const std::map<std::string, TrafficRule>& all() const { return own_.rules.names(); }
  [[nodiscard]] const std::map<std::string, TrafficRule>& patterns() const {
    return own_.rules.patterns();
  }
  /// Whether samples of a topic of this role are of use only while a peer reads it: it crosses on
  /// demand, and no log and no rule needs it.
  [[nodiscard]] bool waits_for_demand(const std::string& topic) const;
  /// Whether this role takes a topic from the link: another role sends it.
  [[nodiscard]] bool takes(const std::string& topic) const;
  /// Whether all other roles that send it do so on demand only.
  [[nodiscard]] bool takes_on_demand(const std::string& topic) const;
  /// Whether another role stores or logs a topic, so that it comes later, too.
  [[nodiscard]] bool takes_later(const std::string& topic) const;
  /// Whether this role keeps what arrives of a topic of another role in its log.
  [[nodiscard]] bool keeps(const std::string& topic) const {
    return kept_here_.find(topic) != nullptr;
  }
  [[nodiscard]] bool keeps_any() const {
    return !kept_here_.names().empty() || !kept_here_.patterns().empty();
  }
  /// What of this role's log crosses by itself.
  [[nodiscard]] const std::vector<FetchRule>& fetches() const { return fetches_; }
  /// Of a service that this role serves for the peers; null: none of these.
  [[nodiscard]] const CallRule* served(const std::string& service) const {
    return served_.find(service);
  }
  /// Of a service that another role serves for this one; null: none of these.
  [[nodiscard]] const CallRule* called(const std::string& service) const {
    return called_.find(service);
  }
  /// In which calls cross, of all roles.
  [[nodiscard]] const std::vector<CallClass>& call_classes() const { return call_classes_; }
  /// Of the packets of a class, 0 to 63: the same for all roles of the file.
  [[nodiscard]] std::uint8_t dscp(TrafficClass traffic_class) const {
    return dscp_.of(traffic_class);
  }
  /// Which paths the samples of a class take: the same for all roles of the file.
  [[nodiscard]] PathUse paths_of(TrafficClass traffic_class) const {
    return paths_[static_cast<std::size_t>(traffic_class)];
  }

 private:
  std::string path_;  ///< empty: without a file
  Role role_ = Role::uxv;
  VehicleChain chain_ = VehicleChain::ours;
  struct Keeps {};
  SentTopics own_;
  std::vector<SentTopics> others_;  ///< of each other role
  NameRules<Keeps> kept_here_;      ///< topics of other roles
  NameRules<CallRule> served_;
  NameRules<CallRule> called_;
  std::vector<CallClass> call_classes_;
  std::vector<FetchRule> fetches_;
  DscpOfClass dscp_;
  std::array<PathUse, traffic_classes.size()> paths_ = default_paths();
};

}  // namespace tocsin
