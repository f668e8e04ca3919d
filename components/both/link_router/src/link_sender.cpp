// SPDX-License-Identifier: Apache-2.0
// What the host offers, the pause, the peers; what is put on the wire is in link_sender_wire.cpp,
// what acknowledgements tell in link_sender_acknowledgements.cpp.
#include "link_router/link_sender.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace tocsin::router {
namespace {

/// Sources of one stream that are remembered; then the one unheard for longest goes.
constexpr std::size_t most_sources = 64;
/// A measured nominal rate is forgotten with this time constant.
constexpr double peak_memory_s = 20;

Time later(Time time, Duration by) { return by > never - time ? never : time + by; }

Duration patience_of(const LinkRouterParams& params) {
  return seconds(params.hold_backlog_s + params.acknowledgement_delay_s +
                 params.acknowledgement_period_s);
}

}  // namespace

LinkSender::LinkSender(const LinkRouterParams& params)
    : params_(params),
      queue_(static_cast<std::size_t>(params.queue_bytes)),
      log_(patience_of(params)),
      scale_(params) {
  check(params);
}

void LinkSender::add_stream(StreamId stream, const StreamRule& rule) {
  assert(rule.depth > 0);
  const bool is_new = streams_.try_emplace(stream, Stream{}).second;
  assert(is_new);
  streams_[stream].rule = rule;
}

void LinkSender::remove_stream(StreamId stream) {
  const auto found = streams_.find(stream);
  if (found == streams_.end()) return;
  for (const Waiting& waiting : queue_.take_stream(stream)) {
    count_dropped(found->second, waiting, DropReason::removed);
  }
  for (const auto& entry : found->second.sources) {
    if (entry.second.held) count_dropped(found->second, *entry.second.held, DropReason::removed);
  }
  for (const SentSamplePtr& sent : open_) {
    if (sent->stream != stream) continue;
    tell_fate(*sent, LiveFate::did_not_cross);
    sent->superseded = true;
    sent->under_way = 0;
  }
  streams_.erase(found);
  log_.forget_stream(stream);
  for (auto& entry : peers_) entry.second.wanted.erase(stream);
}

void LinkSender::on_peer(const std::string& peer, Incarnation incarnation, Time now) {
  const auto known = peers_.find(peer);
  if (known != peers_.end()) {
    if (known->second.incarnation == incarnation) return;
    forget_peer(peer, now);
  }
  peers_.emplace(std::piecewise_construct, std::forward_as_tuple(peer),
                 std::forward_as_tuple(params_, ++last_peer_, incarnation));
}

void LinkSender::forget_peer(const std::string& peer, Time now) {
  const auto known = peers_.find(peer);
  if (known == peers_.end()) return;
  const PeerIndex index = known->second.index;
  peers_.erase(known);
  apply(log_.forget_peer(index), now);
  for (const SentSamplePtr& sent : open_) {
    auto& missing = sent->missing;
    missing.erase(std::remove(missing.begin(), missing.end(), index), missing.end());
  }
  conclude_all(now);
}

void LinkSender::set_wanted(const std::string& peer, StreamId stream, bool wanted, Time now) {
  const auto known = peers_.find(peer);
  const auto found = streams_.find(stream);
  if (known == peers_.end() || found == streams_.end()) return;
  Peer& to = known->second;
  if (!wanted) {
    to.wanted.erase(stream);
    for (const SentSamplePtr& sent : open_) {
      if (sent->stream != stream) continue;
      auto& missing = sent->missing;
      missing.erase(std::remove(missing.begin(), missing.end(), to.index), missing.end());
    }
    return conclude_all(now);
  }
  if (!to.wanted.insert(stream).second || !found->second.rule.durable) return;
  for (auto& entry : found->second.sources) {
    const SentSamplePtr& newest = entry.second.newest;
    if (!newest || now > newest->expires) continue;
    const auto copy = std::make_shared<SentSample>(*newest);
    copy->missing = {to.index};
    copy->under_way = 0;
    copy->repair_at = now;
    copy->transmissions = 0;
    copy->counted = false;
    copy->superseded = false;
    copy->fate = SentSample::Fate::open;
    open_.push_back(copy);
  }
}

bool LinkSender::is_paused(const StreamRule& rule) const {
  return paused_ && rule.while_paused != WhilePaused::send;
}

LinkSender::Source& LinkSender::source_of(Stream& stream, const Sample& sample) const {
  const auto [place, is_new] = stream.sources.try_emplace(sample.origin.source);
  if (is_new && stream.sources.size() > most_sources) {
    auto oldest = stream.sources.end();
    for (auto it = stream.sources.begin(); it != stream.sources.end(); ++it) {
      if (it == place || it->second.held) continue;
      if (oldest == stream.sources.end() || it->second.sent < oldest->second.sent) oldest = it;
    }
    if (oldest != stream.sources.end()) stream.sources.erase(oldest);
  }
  return place->second;
}

void LinkSender::meter_offer(Stream& stream, const WireCost& cost, Time now) {
  if (stream.offered != Time::min()) {
    const Duration since = now - stream.offered;
    stream.peak_bytes_per_s *= std::exp(-to_seconds(since) / peak_memory_s);
  }
  stream.offered = now;
  if (!stream.rule.adaptive) return;
  const double nominal = static_cast<double>(cost.bytes) / scale_.scale();
  stream.nominal.add(static_cast<std::size_t>(nominal), now);
  stream.peak_bytes_per_s = std::max(stream.peak_bytes_per_s, stream.nominal.bytes_per_s(now));
}

void LinkSender::offer(StreamId stream, const Sample& sample, Time now) {
  const auto found = streams_.find(stream);
  assert(found != streams_.end());
  Stream& to = found->second;
  ++counts(to.rule.traffic_class).offered;
  ++to.counts.offered;
  const WireCost cost = wire_cost(sample.bytes);
  meter_offer(to, cost, now);
  const Waiting waiting{stream, sample, cost, now, later(now, to.rule.lifespan)};
  is_paused(to.rule) ? hold(to, waiting) : enqueue(to, waiting);
}

void LinkSender::enqueue(Stream& stream, const Waiting& waiting) {
  count_dropped(queue_.add(stream.rule.traffic_class, stream.rule.depth, waiting));
}

void LinkSender::hold(Stream& stream, const Waiting& waiting) {
  if (stream.rule.while_paused == WhilePaused::drop) {
    count_dropped(stream, waiting, DropReason::paused);
    return;
  }
  auto& held = source_of(stream, waiting.sample).held;
  if (held) count_dropped(stream, *held, DropReason::paused);
  held = waiting;
}

void LinkSender::set_paused(bool paused, Time now) {
  if (paused == paused_) return;
  paused_ = paused;
  for (auto& [id, stream] : streams_) {
    if (stream.rule.while_paused == WhilePaused::send) continue;
    if (paused) {
      for (const Waiting& waiting : queue_.take_stream(id)) hold(stream, waiting);
      continue;
    }
    for (auto& entry : stream.sources) {
      if (!entry.second.held) continue;
      enqueue(stream, *std::exchange(entry.second.held, std::nullopt));
    }
  }
  count_dropped(queue_.take_expired(now));
}

void LinkSender::count_dropped(const std::vector<Dropped>& dropped) {
  for (const Dropped& one : dropped) {
    count_dropped(streams_.at(one.waiting.stream), one.waiting, one.reason);
  }
}

void LinkSender::count_dropped(Stream& stream, const Waiting& waiting, DropReason reason) {
  ++counts(stream.rule.traffic_class).dropped[static_cast<std::size_t>(reason)];
  ++stream.counts.dropped;
  if (reason == DropReason::paused) ++stream.counts.paused;
  if (!stream.rule.stored) return;
  fates_.push_back({waiting.stream, waiting.sample.origin, LiveFate::did_not_cross});
}

void LinkSender::tell_fate(const SentSample& sent, LiveFate fate) {
  const auto stream = streams_.find(sent.stream);
  if (!sent.counted || stream == streams_.end() || !stream->second.rule.stored) return;
  fates_.push_back({sent.stream, sent.sample.origin, fate});
}

StreamCounts LinkSender::stream_counts(StreamId stream) const {
  const auto found = streams_.find(stream);
  return found == streams_.end() ? StreamCounts{} : found->second.counts;
}

std::vector<StreamBudget> LinkSender::budgets(Time now) const {
  std::vector<StreamBudget> budgets;
  const bool full = backlog(now) > seconds(params_.hold_backlog_s);
  for (const auto& [id, stream] : streams_) {
    if (!stream.rule.adaptive) continue;
    const bool hold = full || queue_.has(id);
    budgets.push_back({id, scale_.scale() * stream.peak_bytes_per_s, scale_.scale(), hold});
  }
  return budgets;
}

LinkStateValues LinkSender::state(Time now) const {
  LinkStateValues values;
  values.classes = counts_;
  for (const TrafficClass traffic_class : traffic_classes) {
    ClassCounts& counts = values.classes[index_of(traffic_class)];
    counts.waiting_samples = queue_.samples(traffic_class);
    counts.waiting_bytes = queue_.bytes(traffic_class);
  }
  for (const auto& [id, stream] : streams_) {
    ClassCounts& counts = values.classes[index_of(stream.rule.traffic_class)];
    for (const auto& entry : stream.sources) {
      if (!entry.second.held) continue;
      ++counts.waiting_samples;
      counts.waiting_bytes += entry.second.held->sample.bytes;
    }
  }
  values.capacity_bytes_per_s = capacity_bytes_per_s(now);
  const LinkEstimator* const slowest = slowest_peer(now);
  values.capacity_measured = slowest != nullptr && slowest->is_capacity_measured();
  values.backlog = backlog(now);
  values.scale = scale_.scale();
  values.repair_share = std::min(repairs_.bytes_per_s(now) / values.capacity_bytes_per_s, 1.0);
  values.paused = paused_;
  for (const auto& entry : peers_) {
    const LinkEstimator& estimator = entry.second.estimator;
    ++(estimator.is_silent(now) ? values.silent_peers : values.live_peers);
    values.loss = std::max(values.loss, estimator.loss());
  }
  return values;
}

}  // namespace tocsin::router
