// SPDX-License-Identifier: Apache-2.0
// What a LinkRouterComponent does for its logs now and then, and what this host wants of logs.
#include "arrival_log.hpp"
#include "fill_in_link.hpp"
#include "fill_in_messages.hpp"
#include "foundation/hash.hpp"
#include "link_router/link_router_component.hpp"
#include "router_store.hpp"

namespace tocsin {
namespace {

/// Between what the store keeps up besides: ages, and what a power cut may take.
constexpr Duration keep_period = std::chrono::seconds(5);
/// Who wants the vehicle to stop says it several times a second: after so long without a word it is
/// another stop.
constexpr Duration same_stop = std::chrono::seconds(5);

}  // namespace

void LinkRouterComponent::take_requests(Time now) {
  while (const auto message = log_requests_.take()) {
    const auto range = to_range(*message);
    if (!range) continue;
    standing_.on_request(*range, now);
    fill_ins_->request(*range, now);
  }
  while (const auto stop = stop_ ? stop_->take() : nullptr) {
    if (!stop->data()) continue;
    const bool is_new = stop_heard_ == Time{} || now - stop_heard_ > same_stop;
    stop_heard_ = now;
    if (is_new) fetch_around(now);
  }
}

void LinkRouterComponent::fetch_around(Time stop) {
  const Duration around = seconds(params_.fetch_around_stop_s);
  const std::int64_t stop_ns = bus().wall_ns(stop);
  for (const std::string& topic : fill_ins_->logged_topics()) {
    const std::uint64_t id = hash_of(topic + " " + std::to_string(stop_ns));
    fill_ins_->request_by_rule({id, topic, stop_ns - around.count(), stop_ns + around.count()},
                               stop);
  }
}

/// What an earlier life has left crosses though nobody writes it now.
void LinkRouterComponent::keep_store(Time now) {
  next_keep_ = next_instant(keep_period, now);
  if (fill_ins_->flow()) store_->open(now, bus().wall_ns(now));
  if (fill_ins_->logs() || arrivals_->keeps_any()) history_->open(now, bus().wall_ns(now));
  store_->keep(now);
  history_->keep(now);
}

}  // namespace tocsin
