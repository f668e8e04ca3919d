// SPDX-License-Identifier: Apache-2.0
#include "fetch_trigger.hpp"

#include <utility>

#include <algorithm>
#include <string>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"
#include "idl_support/topic_registry.hpp"
#include "runtime/middleware/idl_libraries.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

std::optional<KnownTopic> registered(const std::string& name) {
  for (const KnownTopic& one : known_topics()) {
    if (one.info.name == name) return one;
  }
  return std::nullopt;
}

KnownTopic known_topic(const FetchRule& rule) {
  if (const auto known = registered(rule.when)) return *known;
  load_idl_libraries();
  if (const auto known = registered(rule.when)) return *known;
  std::vector<std::string> names;
  for (const KnownTopic& one : known_topics()) names.emplace_back(one.info.name);
  throw ConfigError(rule.name + ".when: no installed package knows a topic " +
                    printable(rule.when) + did_you_mean(names, rule.when, "they know"));
}

Endpoint endpoint_of(const FetchRule& rule) {
  const KnownTopic topic = known_topic(rule);
  return {topic.info, topic.type, Writers::optional};
}

}  // namespace

FetchTrigger::FetchTrigger(Component& owner, const FetchRule& rule)
    : rule_(rule),
      input_(owner, endpoint_of(rule), WakeMode::time_triggered),
      condition_(*endpoint_of(rule).type, rule) {}

std::optional<Time> FetchTrigger::take() {
  std::optional<Time> event;
  while (const auto sample = input_.take_sample()) {
    if (sample->message == nullptr) continue;
    const bool went_on = std::exchange(holds_, condition_.holds(sample->message.get()));
    if (!holds_) continue;
    const bool has_state = rule_.is != FetchRule::Is::any;
    const bool is_late = !last_ || sample->received - *last_ > seconds(rule_.min_interval_s);
    const bool is_new = is_late && !(has_state && went_on);
    last_ = sample->received;
    if (is_new) event = sample->received;
  }
  return event;
}

FetchRule around_stop(double s) {
  FetchRule rule;
  rule.when = topic::SafetyStatus::info.name;
  rule.field = "emergency_stop";
  rule.is = FetchRule::Is::equal;
  rule.value = "true";
  rule.topics = {"*"};
  rule.before_s = s;
  rule.after_s = s;
  rule.min_interval_s = 5;
  rule.name = "link_router.fetch_around_stop_s";
  return rule;
}

std::vector<std::unique_ptr<FetchTrigger>> make_triggers(Component& owner,
                                                         const std::vector<FetchRule>& rules,
                                                         double around_stop_s) {
  std::vector<std::unique_ptr<FetchTrigger>> triggers;
  for (const FetchRule& rule : rules) {
    triggers.push_back(std::make_unique<FetchTrigger>(owner, rule));
  }
  if (around_stop_s > 0) {
    triggers.push_back(std::make_unique<FetchTrigger>(owner, around_stop(around_stop_s)));
  }
  return triggers;
}

}  // namespace tocsin
