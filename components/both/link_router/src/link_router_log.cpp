// SPDX-License-Identifier: Apache-2.0
// What a LinkRouterComponent does for its logs now and then, and what this host wants of logs.
#include <algorithm>
#include <set>
#include <string>

#include "arrival_log.hpp"
#include "backfill_link.hpp"
#include "backfill_messages.hpp"
#include "fetch_trigger.hpp"
#include "foundation/hash.hpp"
#include "link_router/link_router_component.hpp"
#include "router_store.hpp"

namespace tocsin {
namespace {

/// Between what the store keeps up besides: ages, and what a power cut may take.
constexpr Duration keep_period = std::chrono::seconds(5);

}  // namespace

void LinkRouterComponent::take_requests(Time now) {
  while (const auto message = log_requests_.take()) {
    const auto range = to_range(*message);
    if (!range) continue;
    standing_.on_request(*range, now);
    backfills_->request(*range, now);
  }
  if (!backfills_->knows_requests()) return;
  const std::set<std::string> resumed = backfills_->take_resumed_rules();
  for (const auto& trigger : triggers_) {
    if (resumed.count(trigger->rule().name) != 0) trigger->resume(now);
    if (const auto event = trigger->take()) fetch_around(*trigger, *event, now);
  }
}

void LinkRouterComponent::fetch_around(const FetchTrigger& trigger, Time event, Time now) {
  const FetchRule& rule = trigger.rule();
  const std::int64_t event_ns = bus().wall_ns(event);
  for (const std::string& topic : backfills_->logged_topics()) {
    const bool is_wanted =
        std::any_of(rule.topics.begin(), rule.topics.end(),
                    [&topic](const std::string& one) { return one == topic || fits(one, topic); });
    if (!is_wanted) continue;
    const std::uint64_t id = hash_of(rule.name + " " + topic + " " + std::to_string(event_ns));
    const router::HistoryRange range{id, topic, event_ns - seconds(rule.before_s).count(),
                                     event_ns + seconds(rule.after_s).count()};
    if (!backfills_->request({range, rule.name}, now, bus().wall_ns(now))) {
      log().warn("{}: too much is being fetched; {} around this event is left out", rule.name,
                 topic);
    }
  }
}

/// What an earlier life has left crosses though nobody writes it now.
void LinkRouterComponent::keep_store(Time now) {
  next_keep_ = next_instant(keep_period, now);
  if (backfills_->flow()) store_->open(now, bus().wall_ns(now));
  if (backfills_->logs() || arrivals_->keeps_any()) history_->open(now, bus().wall_ns(now));
  store_->keep(now);
  history_->keep(now);
}

}  // namespace tocsin
