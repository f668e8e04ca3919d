// SPDX-License-Identifier: Apache-2.0
#include "matches.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "foundation/joined.hpp"
#include "foundation/printable.hpp"
#include "runtime/middleware/qos_matching.hpp"

namespace tocsin::qos_tool {
namespace {

bool types_differ(const Pair& pair) {
  return !pair.writer.type.empty() && !pair.reader.type.empty() &&
         pair.writer.type != pair.reader.type;
}

std::string type_line(const Pair& pair) {
  return fmt::format("  STOPS  type: the writer's is {}, the reader's {}\n",
                     printable(pair.writer.type), printable(pair.reader.type));
}

std::string rule_line(const MatchingRule& rule, const Pair& pair, bool met) {
  return fmt::format("  {}  {}: offered {}, requested {} ({})\n", met ? "fits " : "STOPS",
                     rule.policy, printable(rule.value(pair.writer.qos)),
                     printable(rule.value(pair.reader.qos)), rule.rule);
}

std::string head(const Pair& pair) {
  const auto stopped = pair.stopped_by();
  const std::string result =
      stopped.empty() ? "match" : "do not match, stopped by " + joined(stopped);
  return fmt::format("{} and {} {}\n", printable(pair.writer.name), printable(pair.reader.name),
                     result);
}

}  // namespace

std::vector<std::string> Pair::stopped_by() const {
  std::vector<std::string> policies = incompatibilities(writer.qos, reader.qos);
  if (types_differ(*this)) policies.insert(policies.begin(), "type");
  return policies;
}

bool Pair::fast_dds_departs() const {
  return incompatibilities(writer.qos, reader.qos).empty() !=
         incompatibilities_for_fast_dds(writer.qos, reader.qos).empty();
}

End writer_of(const std::string& name, const QosProfile& profile) {
  return {"a writer of profile " + name, "", profile};
}

End reader_of(const std::string& name, const QosProfile& profile) {
  const TopicInfo any{"", "", Scope::host};
  return {"a reader of profile " + name, "", requested(any, profile)};
}

std::vector<End> ends_of(const std::vector<GraphEnd>& ends, const std::string& topic,
                         bool writers) {
  std::vector<End> found;
  for (const GraphEnd& one : ends) {
    if (one.topic != topic || one.writer != writers) continue;
    const std::string whose = one.participant.empty() ? "an unnamed participant" : one.participant;
    found.push_back(
        {fmt::format("the {} in {}", writers ? "writer" : "reader", whose), one.type, one.qos});
  }
  return found;
}

std::vector<Pair> pairs_of(const std::vector<End>& writers, const std::vector<End>& readers) {
  std::vector<Pair> pairs;
  for (const End& writer : writers) {
    for (const End& reader : readers) pairs.push_back({writer, reader});
  }
  return pairs;
}

std::string match_text(const std::vector<Pair>& pairs, bool all) {
  std::string text;
  for (const Pair& pair : pairs) {
    text += head(pair);
    if (types_differ(pair)) text += type_line(pair);
    for (const MatchingRule& rule : matching_rules()) {
      const bool met = rule.met(pair.writer.qos, pair.reader.qos);
      if (all || !met) text += rule_line(rule, pair, met);
    }
    if (pair.fast_dds_departs()) {
      text += "  Fast DDS 2.9.1 does not look at that, or not so: two ends of it match\n";
    }
  }
  return text;
}

nlohmann::json match_json(const std::vector<Pair>& pairs) {
  nlohmann::json all = nlohmann::json::array();
  for (const Pair& pair : pairs) {
    nlohmann::json policies = nlohmann::json::object();
    for (const MatchingRule& rule : matching_rules()) {
      policies[rule.policy] = {{"offered", printable(rule.value(pair.writer.qos))},
                               {"requested", printable(rule.value(pair.reader.qos))},
                               {"fits", rule.met(pair.writer.qos, pair.reader.qos)}};
    }
    all.push_back({{"writer", printable(pair.writer.name)},
                   {"reader", printable(pair.reader.name)},
                   {"matches", pair.stopped_by().empty()},
                   {"stopped_by", pair.stopped_by()},
                   {"policies", policies}});
  }
  return all;
}

}  // namespace tocsin::qos_tool
