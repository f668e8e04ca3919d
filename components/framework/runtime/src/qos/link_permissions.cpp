// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/link_permissions.hpp"

#include <algorithm>

#include "qos/topic_names.hpp"

namespace tocsin {
namespace {

std::string topic_of(const std::string& start, const CallClass& calls) {
  return start + to_string(calls.server) + "_" + to_string(calls.traffic_class);
}

std::vector<std::string> topics_of(Role role, const LinkSide& side) {
  const TopicNames names = link_names();
  std::vector<std::string> topics;
  const TrafficRules rules(side.traffic_file, role);
  for (const auto* of : {&rules.all(), &rules.patterns()}) {
    for (const auto& [topic, rule] : *of) {
      if (rule.live) topics.push_back(names.on_wire(topic));
    }
  }
  if (!rules.call_classes().empty()) topics.push_back(names.on_wire(link_services_topic));
  for (const CallClass& one : rules.call_classes()) {
    topics.push_back(names.on_wire(link_calls_topic(one)));
    topics.push_back(names.on_wire(link_results_topic(one)));
  }
  topics.push_back(names.on_wire(link_acknowledgement_topic));
  topics.push_back(names.on_wire(backfill_topic));
  return topics;
}

}  // namespace

std::string link_calls_topic(const CallClass& calls) { return topic_of("link_calls_", calls); }

std::string link_results_topic(const CallClass& calls) { return topic_of("link_results_", calls); }

bool is_of_routers(const TrafficRules& rules, const std::string& topic) {
  if (topic == link_acknowledgement_topic || topic == backfill_topic) return true;
  const auto& calls = rules.call_classes();
  if (topic == link_services_topic) return !calls.empty();
  return std::any_of(calls.begin(), calls.end(), [&](const CallClass& one) {
    return topic == link_calls_topic(one) || topic == link_results_topic(one);
  });
}

LinkPurpose purpose_of(const std::string& topic) {
  if (topic == link_acknowledgement_topic) return LinkPurpose::acknowledgements;
  return topic == backfill_topic ? LinkPurpose::backfill : LinkPurpose::samples;
}

keystore::Permissions link_permissions(const LinkSide& side) {
  const Role other = side.role == Role::uxv ? Role::gcs : Role::uxv;
  return {topics_of(side.role, side), topics_of(other, side)};
}

}  // namespace tocsin
