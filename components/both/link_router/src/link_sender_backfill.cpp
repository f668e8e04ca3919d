// SPDX-License-Identifier: Apache-2.0
// When a LinkSender has room for what did not cross at first.
#include <algorithm>

#include "link_router/link_sender.hpp"

namespace tocsin::router {

void LinkSender::add_backfill_stream(StreamId stream) {
  StreamRule rule;
  rule.name = "backfill";
  add_stream(stream, rule);
  streams_.at(stream).fills_in = true;
}

bool LinkSender::may_backfill(Time now) const {
  const bool waits = std::any_of(traffic_classes.begin(), traffic_classes.end(),
                                 [this](TrafficClass one) { return queue_.samples(one) > 0; });
  if (peers_.empty() || paused_ || waits) return false;
  if (is_silent(now))
    return now - sent_at_ >= seconds(params_.repair_max_s);  // it may find it alive
  return bulk_may_go(now) && backlog(now) == Duration::zero();
}

Time LinkSender::backfill_opens(Time now) const {
  if (may_backfill(now)) return now;
  if (peers_.empty() || paused_) return never;
  if (is_silent(now)) return sent_at_ + seconds(params_.repair_max_s);
  const Time drained = now + backlog(now);
  return drained > now ? drained : never;
}

void LinkSender::backfill(StreamId stream, const Sample& sample, Time now) {
  const auto sent = std::make_shared<SentSample>();
  sent->stream = stream;
  sent->traffic_class = streams_.at(stream).rule.traffic_class;
  sent->sample = sample;
  sent->cost = wire_cost(sample.bytes);
  sent->offered = now;
  sent->expires = now;
  sent->counted = false;
  sent->superseded = true;
  for (const auto& entry : peers_) {
    if (entry.second.wanted.count(stream) != 0) sent->missing.push_back(entry.second.index);
  }
  open_.push_back(sent);
  (void)transmit(sent, now);
}

}  // namespace tocsin::router
