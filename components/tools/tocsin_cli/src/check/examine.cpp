// SPDX-License-Identifier: Apache-2.0
#include "examine.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <set>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/spelling.hpp"
#include "runtime/middleware/qos_matching.hpp"

namespace tocsin::check {
namespace {

/// A port with the component that has it.
struct End {
  const Node* node;
  const Port* port;
};

using Ends = std::vector<End>;

std::map<std::string, Ends> by_topic(const Graph& graph) {
  std::map<std::string, Ends> topics;
  for (const Node& node : graph) {
    for (const Port& port : node.ports) topics[port.topic].push_back({&node, &port});
  }
  return topics;
}

bool reaches(const End& writer, const End& reader) {
  return writer.port->scope == Scope::link || writer.node->host == reader.node->host;
}

const char* name_of(Scope scope) { return scope == Scope::link ? "link" : "host"; }

/// "uxv/drive/navigator writes"
std::string action(const End& end) {
  return end.node->path() + (end.port->writes ? " writes" : " reads");
}

/// What a port without counterpart lacks.
enum class Lack { writer, writer_at_will, reader };

Lack lack_of(const Port& port) {
  if (port.writes) return Lack::reader;
  return port.writers == Writers::needed ? Lack::writer : Lack::writer_at_will;
}

const char* text_of(Lack lack) {
  switch (lack) {
    case Lack::writer:
      return ": nobody writes what it reads: ";
    case Lack::writer_at_will:
      return ": nobody writes what it would read as well: ";
    case Lack::reader:
      return ": nobody reads what it writes: ";
  }
  return "";
}

/// Collects what is found about one graph.
class Examiner {
 public:
  Examiner(const Graph& graph, const Rules& rules)
      : graph_(graph), rules_(rules), topics_(by_topic(graph)) {}

  std::vector<Finding> run() {
    for (const auto& [topic, ends] : topics_) {
      check_agreement(topic, ends);
      check_contracts(topic, ends);
    }
    for (const Node& node : graph_) check_node(node);
    check_unused_rules();
    return std::move(findings_);
  }

 private:
  void add(Severity severity, std::string text) {
    findings_.push_back({severity, std::move(text)});
  }

  /// Every end of a topic must say the same as the first.
  void check_agreement(const std::string& topic, const Ends& ends) {
    const End& first = ends.front();
    for (const End& other : ends) {
      const auto clash = [&](const char* what, const std::string& a, const std::string& b) {
        if (a == b) return;
        add(Severity::error, "topic " + topic + ": " + action(first) + " it with " + what + " " +
                                 a + ", " + action(other) + " it with " + what + " " + b);
      };
      clash("type", first.port->type, other.port->type);
      clash("scope", name_of(first.port->scope), name_of(other.port->scope));
    }
  }

  /// The profile of an end; reports a missing one once.
  std::optional<QosProfile> profile(const std::string& topic, const Port& port) {
    try {
      return rules_.qos.of(port.qos, topic);
    } catch (const ConfigError& error) {
      if (missing_.insert(error.what()).second) add(Severity::error, error.what());
      return std::nullopt;
    }
  }

  void check_contracts(const std::string& topic, const Ends& ends) {
    for (const End& writer : ends) {
      if (!writer.port->writes) continue;
      const auto offered = profile(topic, *writer.port);
      for (const End& reader : ends) {
        if (reader.port->writes || !reaches(writer, reader)) continue;
        const auto known = profile(topic, *reader.port);
        const Port& port = *reader.port;
        const TopicInfo info{topic.c_str(), port.qos.c_str(), port.scope, port.requests};
        if (offered && known) check_pair(writer, *offered, reader, requested(info, *known));
      }
    }
  }

  void check_pair(const End& writer, const QosContract& offered, const End& reader,
                  const QosContract& requested) {
    const auto policies = incompatibilities_for_fast_dds(offered, requested);
    if (policies.empty()) return;
    add(Severity::error, "topic " + writer.port->topic + ": " + action(writer) +
                             " it with QoS profile " + writer.port->qos + ", " + action(reader) +
                             " it with " + reader.port->qos +
                             "; they will not match, by: " + joined(policies));
  }

  void check_node(const Node& node) {
    std::map<Lack, std::vector<std::string>> alone;
    for (const Port& port : node.ports) {
      const End end{&node, &port};
      check_class(end);
      check_owners(end);
      if (has_counterpart(end) || may_be_written_far_away(port)) continue;
      const Lack lack = lack_of(port);
      alone[lack].push_back(port.topic);
      if (lack == Lack::writer) check_reach(end);
      if (lack == Lack::reader) check_velocity(end);
    }
    for (const auto& [lack, topics] : alone) {
      add(lack == Lack::writer ? Severity::warning : Severity::note,
          node.path() + text_of(lack) + joined(topics));
    }
  }

  [[nodiscard]] bool has_counterpart(const End& end) const {
    const Ends& ends = topics_.at(end.port->topic);
    return std::any_of(ends.begin(), ends.end(), [&](const End& other) {
      return other.port->writes != end.port->writes &&
             (end.port->writes ? reaches(end, other) : reaches(other, end));
    });
  }

  [[nodiscard]] bool may_be_written_far_away(const Port& port) const {
    return rules_.has_far_end && !port.writes && port.scope == Scope::link;
  }

  /// A reader without a writer in reach: is there one out of reach?
  void check_reach(const End& reader) {
    for (const End& writer : topics_.at(reader.port->topic)) {
      if (!writer.port->writes) continue;
      add(Severity::warning, "topic " + reader.port->topic + ": " + action(writer) + " it, " +
                                 action(reader) + " it on another host, and its scope is host");
      return;
    }
  }

  /// A part of the velocity chain that nobody follows has no effect, and a brake must have one.
  void check_velocity(const End& writer) {
    if (writer.port->topic.rfind("cmd_vel/", 0) != 0) return;
    const bool is_brake = writer.port->topic == "cmd_vel/checked";
    add(Severity::warning, writer.node->path() + ": nobody follows its velocity " +
                               writer.port->topic +
                               (is_brake ? ": set velocity_smoother.checked to true" : ""));
  }

  void check_class(const End& writer) {
    if (!writer.port->writes || writer.port->scope != Scope::link) return;
    const auto rules = rules_.traffic.find(writer.node->role);
    if (rules == rules_.traffic.end()) return;
    add_refusal([&] { (void)rules->second.of(writer.port->topic); });
  }

  void check_owners(const End& end) {
    const Port& port = *end.port;
    if (const auto qos = profile(port.topic, port)) {
      add_refusal([&] {
        refuse_owners_on_link({port.topic.c_str(), port.qos.c_str(), port.scope}, *qos);
      });
    }
  }

  /// What `ask` throws is an error, once.
  template <class Ask>
  void add_refusal(const Ask& ask) {
    try {
      ask();
    } catch (const ConfigError& error) {
      if (missing_.insert(error.what()).second) add(Severity::error, error.what());
    }
  }

  [[nodiscard]] bool written_by_role(const std::string& topic, Role role) const {
    const auto found = topics_.find(topic);
    return found != topics_.end() &&
           std::any_of(found->second.begin(), found->second.end(),
                       [&](const End& end) { return end.port->writes && end.node->role == role; });
  }

  [[nodiscard]] bool is_known(const std::string& topic) const {
    return topics_.count(topic) != 0 ||
           std::find(rules_.topics.begin(), rules_.topics.end(), topic) != rules_.topics.end();
  }

  /// A topic that nobody knows may be of a program that is not ours; one that is spelt almost like
  /// a topic without a rule of its own is misspelt.
  void check_spelling(const std::string& topic, Role role, const TrafficRules& rules) {
    if (is_known(topic)) return;
    std::set<std::string> without_rule(rules_.topics.begin(), rules_.topics.end());
    for (const auto& one : topics_) without_rule.insert(one.first);
    for (const auto& rule : rules.all()) without_rule.erase(rule.first);
    const std::string like = suggestion({without_rule.begin(), without_rule.end()}, topic);
    if (like.empty()) return;
    add(Severity::warning, "traffic rules of role " + std::string(to_string(role)) + ": topic " +
                               topic + " is not known here" + like);
  }

  void check_unused_rules() {
    for (const auto& [role, rules] : rules_.traffic) {
      std::vector<std::string> unused;
      for (const auto& [topic, rule] : rules.all()) {
        if (written_by_role(topic, role)) continue;
        unused.push_back(topic);
        check_spelling(topic, role, rules);
      }
      if (unused.empty()) continue;
      add(Severity::note, "traffic rules of role " + std::string(to_string(role)) +
                              " name topics that nothing in this " +
                              "role writes: " + joined(unused));
    }
    for (const std::string& topic : rules_.qos.overridden_topics()) {
      if (topics_.count(topic) != 0) continue;
      add(Severity::warning, "QoS overrides: topic " + topic + " is not in this deployment");
    }
  }

  const Graph& graph_;
  const Rules& rules_;
  const std::map<std::string, Ends> topics_;
  std::set<std::string> missing_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> examine(const Graph& graph, const Rules& rules) {
  return Examiner(graph, rules).run();
}

}  // namespace tocsin::check
