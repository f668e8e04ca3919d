// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_counters.hpp"

namespace tocsin::router {

void LinkCounters::on_offered(StreamId stream, TrafficClass traffic_class) {
  ++of(traffic_class).offered;
  ++streams_[stream].offered;
}

void LinkCounters::on_first_sent(const SentSample& sent) {
  ++of(sent.traffic_class).sent;
  ++streams_[sent.stream].sent;
}

void LinkCounters::on_dropped(const Waiting& waiting, const StreamRule& rule, DropReason reason) {
  ++of(rule.traffic_class).dropped[static_cast<std::size_t>(reason)];
  StreamCounts& stream = streams_[waiting.stream];
  ++stream.dropped;
  if (reason == DropReason::paused) ++stream.paused;
  if (!rule.stored) return;
  fates_.push_back({waiting.stream, waiting.sample.origin, LiveFate::not_delivered});
}

void LinkCounters::note_fate(const SentSample& sent, LiveFate fate) {
  if (sent.counted && sent.is_stored) fates_.push_back({sent.stream, sent.sample.origin, fate});
}

void LinkCounters::on_delivered(SentSample& sent) {
  sent.fate = SentSample::Fate::delivered;
  note_fate(sent, LiveFate::delivered);
  if (!sent.counted) return;
  ClassCounts& count = of(sent.traffic_class);
  ++count.delivered;
  if (sent.late) ++count.late;
  if (sent.repaired) ++count.repaired;
}

void LinkCounters::conclude(SentSample& sent) {
  const bool is_unwanted = sent.missing.empty();
  if (is_unwanted && sent.received) return on_delivered(sent);
  sent.fate = is_unwanted ? SentSample::Fate::unwanted : SentSample::Fate::lost;
  note_fate(sent, LiveFate::not_delivered);
  if (!sent.counted) return;
  ClassCounts& count = of(sent.traffic_class);
  ++(is_unwanted ? count.unwanted : count.lost);
}

void LinkCounters::revoke_loss(SentSample& sent) {
  if (sent.counted) --of(sent.traffic_class).lost;
  on_delivered(sent);
}

void LinkCounters::end(SentSample& sent) {
  note_fate(sent, LiveFate::not_delivered);
  sent.is_stored = false;
}

StreamCounts LinkCounters::of_stream(StreamId stream) const {
  const auto found = streams_.find(stream);
  return found == streams_.end() ? StreamCounts{} : found->second;
}

}  // namespace tocsin::router
