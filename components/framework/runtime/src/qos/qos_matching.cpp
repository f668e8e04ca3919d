// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/qos_matching.hpp"

#include <fmt/core.h>
#include <fnmatch.h>

#include <algorithm>
#include <cmath>

#include "foundation/joined.hpp"

namespace tocsin {
namespace {

bool is_expression(const std::string& name) {
  return name.find_first_of("*?[") != std::string::npos;
}

/// An expression stands for names, not for other expressions (section 2.2.3.13).
bool meet(const std::string& one, const std::string& other) {
  if (is_expression(one) && is_expression(other)) return false;
  return fnmatch(one.c_str(), other.c_str(), 0) == 0 || fnmatch(other.c_str(), one.c_str(), 0) == 0;
}

/// No partition is the partition without name.
std::vector<std::string> partitions_of(const QosContract& contract) {
  return contract.partition.empty() ? std::vector<std::string>{""} : contract.partition;
}

bool share_partition(const QosContract& offered, const QosContract& requested) {
  const auto theirs = partitions_of(requested);
  for (const std::string& mine : partitions_of(offered)) {
    const auto meets = [&mine](const std::string& other) { return meet(mine, other); };
    if (std::any_of(theirs.begin(), theirs.end(), meets)) return true;
  }
  return false;
}

bool offers_liveliness(const QosContract& offered, const QosContract& requested) {
  return offered.liveliness >= requested.liveliness &&
         offered.liveliness_lease_s <= requested.liveliness_lease_s;
}

bool offers_presentation(const QosContract& offered, const QosContract& requested) {
  return offered.presentation.scope >= requested.presentation.scope &&
         (offered.presentation.coherent || !requested.presentation.coherent) &&
         (offered.presentation.ordered || !requested.presentation.ordered);
}

std::string presentation_text(const QosContract& contract) {
  const Presentation& presentation = contract.presentation;
  return fmt::format("{}{}{}", word_of(presentation.scope),
                     presentation.coherent ? ", coherent" : "",
                     presentation.ordered ? ", ordered" : "");
}

bool accepts_representation(const QosContract& offered, const QosContract& requested) {
  const auto& accepted = requested.representations;
  return std::find(accepted.begin(), accepted.end(), offered.representations.front()) !=
         accepted.end();
}

std::string representations_text(const QosContract& contract) {
  return joined_of(contract.representations, [](Representation one) { return word_of(one); });
}

std::string partitions_text(const QosContract& contract) {
  return joined_of(partitions_of(contract),
                   [](const std::string& name) { return "'" + name + "'"; });
}

/// Fast DDS 2.9.1 compares as names first, so that an expression meets itself.
bool share_partition_for_fast_dds(const QosContract& offered, const QosContract& requested) {
  const auto theirs = partitions_of(requested);
  for (const std::string& mine : partitions_of(offered)) {
    if (std::find(theirs.begin(), theirs.end(), mine) != theirs.end()) return true;
  }
  return share_partition(offered, requested);
}

using Contract = QosContract;
using Met = bool (*)(const Contract&, const Contract&);
using Value = std::string (*)(const Contract&);

MatchingRule rule_of_both(const char* policy, const char* rule, Met met, Value value) {
  return {policy, rule, met, value, met};
}

/// Fast DDS 2.9.1 announces the policy and does not look at it.
MatchingRule rule_of_specification(const char* policy, const char* rule, Met met, Value value) {
  return {policy, rule, met, value, nullptr};
}

std::vector<MatchingRule> seen_rules() {
  return {
      rule_of_both(
          "reliability", "reliable satisfies both, best_effort only best_effort",
          [](const Contract& o, const Contract& r) { return o.reliable() || !r.reliable(); },
          [](const Contract& c) { return std::string(word_of(c.reliability)); }),
      rule_of_both(
          "durability", "offered at least as strong as requested",
          [](const Contract& o, const Contract& r) { return o.durability >= r.durability; },
          [](const Contract& c) { return std::string(word_of(c.durability)); }),
      rule_of_both(
          "deadline", "offered at most as long as requested",
          [](const Contract& o, const Contract& r) { return o.deadline_s <= r.deadline_s; },
          [](const Contract& c) { return duration_text(c.deadline_s); }),
      rule_of_both("liveliness", "offered kind at least as strong, offered lease at most as long",
                   offers_liveliness,
                   [](const Contract& c) {
                     return fmt::format("{}, {}", word_of(c.liveliness),
                                        duration_text(c.liveliness_lease_s));
                   }),
      rule_of_both(
          "ownership", "the same kind on both sides",
          [](const Contract& o, const Contract& r) { return o.ownership == r.ownership; },
          [](const Contract& c) { return std::string(word_of(c.ownership)); }),
      {"partition", "one name in common; an expression stands for names, not for expressions",
       share_partition, partitions_text, share_partition_for_fast_dds},
  };
}

std::vector<MatchingRule> unseen_rules() {
  return {
      rule_of_specification(
          "latency_budget", "offered at most as long as requested",
          [](const Contract& o, const Contract& r) {
            return o.latency_budget_s <= r.latency_budget_s;
          },
          [](const Contract& c) { return duration_text(c.latency_budget_s); }),
      rule_of_specification(
          "destination_order", "by_source satisfies both, by_reception only by_reception",
          [](const Contract& o, const Contract& r) {
            return o.destination_order >= r.destination_order;
          },
          [](const Contract& c) { return std::string(word_of(c.destination_order)); }),
      rule_of_specification("presentation",
                            "offered scope at least as wide; coherent and ordered if requested",
                            offers_presentation, presentation_text),
      rule_of_specification("data_representation", "the writer's first is one the reader accepts",
                            accepts_representation, representations_text),
  };
}

std::vector<MatchingRule> table() {
  std::vector<MatchingRule> all = seen_rules();
  for (MatchingRule& one : unseen_rules()) all.push_back(one);
  return all;
}

}  // namespace

const std::vector<MatchingRule>& matching_rules() {
  static const std::vector<MatchingRule> rules = table();
  return rules;
}

std::vector<std::string> incompatibilities(const QosContract& offered,
                                           const QosContract& requested) {
  std::vector<std::string> found;
  for (const MatchingRule& rule : matching_rules()) {
    if (!rule.met(offered, requested)) found.emplace_back(rule.policy);
  }
  return found;
}

std::vector<std::string> incompatibilities_for_fast_dds(const QosContract& offered,
                                                        const QosContract& requested) {
  std::vector<std::string> found;
  for (const MatchingRule& rule : matching_rules()) {
    const auto met = rule.met_for_fast_dds;
    if (met != nullptr && !met(offered, requested)) found.emplace_back(rule.policy);
  }
  return found;
}

std::string duration_text(double s) {
  return std::isinf(s) ? "for ever" : fmt::format("{:.6g} s", s);
}

}  // namespace tocsin
